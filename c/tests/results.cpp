/// Prints what results.c prints, with the C++ library.
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <vector>

#include "brindle/brindle.h"

namespace {

using namespace brindle;

template <class Row, class Select>
void print(const char* name, const std::vector<Row>& rows, std::size_t columns,
           const Select& select) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const Row& row : rows) {
    const auto* numbers = select(row);
    const auto* bytes = reinterpret_cast<const unsigned char*>(numbers);
    for (std::size_t b = 0; b < columns * sizeof *numbers; ++b)
      hash = (hash ^ bytes[b]) * 0x100000001b3u;
  }
  std::printf("%s %lu %lu %016llx\n", name, static_cast<unsigned long>(rows.size()),
              static_cast<unsigned long>(columns), static_cast<unsigned long long>(hash));
}

template <class Row>
void print_rows(const char* name, const std::vector<Row>& rows, std::size_t columns = 3) {
  print(name, rows, columns, [](const Row& row) { return row.data(); });
}

template <class Number>
void print_list(const char* name, const std::vector<Number>& rows) {
  print(name, rows, 1, [](const Number& number) { return &number; });
}

void print_phases(const char* name, const std::vector<Complex>& z) {
  print(name, z, 2, [](const Complex& one) { return reinterpret_cast<const float*>(&one); });
}

void print_pattern(const Surface& surface, const StripePattern& p) {
  const char* const name = "BRINDLE_PATTERN_TRIANGLE_KINDS";
  print_phases(name, p.solution.z);
  print_rows(name, p.waves.directions);
  print_list(name, p.waves.frequencies);
  print(name, p.corners, 3, [](const CornerPhases& c) { return c.phase.data(); });
  print(name, p.corners, 1, [](const CornerPhases& c) { return &c.kind; });
  const PatternQuality& q = p.quality;
  std::printf("%zu %zu %zu %.17g %.17g %.17g\n", q.branches, q.field_singularities,
              q.vertices_without_wave, q.angle_error_mean_deg, q.spacing_error_mean,
              p.solution.energy);
  const StripeCurves curves = stripe_curves(surface, p);
  const char* const of_curves = "BRINDLE_CURVES_ENDS";
  print_rows(of_curves, curves.lines.points);
  print_rows(of_curves, curves.lines.normals);
  print_list(of_curves, curves.lines.offsets);
  print_list(of_curves, curves.lines.closed);
  print_rows(of_curves, curves.ends, 2);
}

void print_samples(const std::vector<Sample>& s) {
  const char* const name = "BRINDLE_SAMPLES_BARYCENTRIC";
  print(name, s, 3, [](const Sample& one) { return one.position.data(); });
  print(name, s, 3, [](const Sample& one) { return one.normal.data(); });
  print(name, s, 3, [](const Sample& one) { return one.direction_u.data(); });
  print(name, s, 3, [](const Sample& one) { return one.direction_v.data(); });
  print(name, s, 2, [](const Sample& one) { return &one.spacing_u; });
  print(name, s, 1, [](const Sample& one) { return &one.triangle; });
  print(name, s, 3, [](const Sample& one) { return one.barycentric.data(); });
}

void print_patterns(const Surface& s, float f) {
  const DirectionField smooth = smooth_direction_field(s);
  const DirectionField turned = rotated(smooth, s.normals, std::numbers::pi_v<float> / 2);
  const StripePattern u = stripe_pattern(s, smooth, f), v = stripe_pattern(s, turned, f);
  print_pattern(s, u);
  print_pattern(s, v);
  print_samples(stripe_samples(s, u, v));
  StripeOptions slack;
  slack.slack = 0.3f;
  slack.solver.cycles = 1;
  print_pattern(
      s, stripe_pattern(s, projected_direction_field({0.3f, 0.9f, 0.2f}, s.normals), f, slack));
  StripeOptions follows;
  follows.last_phases = v.solution.z;
  const auto curvatures = principal_curvatures(s.mesh.positions, s.normals, *s.neighborhood);
  print_pattern(
      s, stripe_pattern(s, curvature_direction_field(curvatures, CurvatureDirection::minimum), f,
                        follows));
}

void print_texture(const TexturedMesh& m) {
  const char* const name = "BRINDLE_TEXTURE_TRIANGLE_ORIGINS";
  print_rows(name, m.mesh.positions);
  print_rows(name, m.mesh.triangles);
  print_rows(name, m.coordinates, 2);
  print_rows(name, m.origins);
  print_list(name, m.triangle_origins);
}

void print_textures(const Surface& s, float f) {
  const TexturePattern texture = texture_pattern(s, smooth_direction_field(s), f);
  print_texture(texture_coordinates(s, texture));
  print_pattern(s, texture.v);
  const WaveSet waves{s.mesh.positions, smooth_direction_field(s, {.symmetry = 4}),
                      constant_frequency_field(f, s.mesh.vertex_count())};
  const CrossTexture tiles = cross_texture(s, cross_pattern(s, waves));
  print_texture(texture_coordinates(tiles.surface, tiles.pattern));
}

void print_frames(const Surface& s, float f) {
  AnimatorOptions options;
  options.slack = 0.2f;
  StripeAnimator animator(s, options);
  PatternFrames frames(s);
  std::vector<PatternVertex> vertices(s.mesh.vertex_count());
  const FrequencyField frequencies = constant_frequency_field(f, vertices.size());
  for (int n = 0; n < 4; ++n) {
    const Vec3 axis = Eigen::Vector3d(0.3, 0.9, 0.1 * n).cast<float>();
    const DirectionField field = projected_direction_field(axis, s.normals);
    const FrameInput input{s.mesh.positions, field, frequencies};
    const FrameResult result = animator.frame(input);
    print_phases("phases", {result.z.begin(), result.z.end()});
    print_list<float>("frequencies", {result.frequencies.begin(), result.frequencies.end()});
    std::printf("%.17g %d\n", result.phase_step, result.unchanged ? 1 : 0);
    frames.fill(input, result, vertices);
    print("vertices", vertices, 12, [](const PatternVertex& v) { return v.position.data(); });
  }
}

}  // namespace

int main() {
  for (const char* shape : {"torus,resolution=24", "box,resolution=12"}) {
    Mesh mesh = make_shape(shape);
    Creases creases = split_at_creases(mesh);
    const Surface s = make_surface(std::move(mesh), std::move(creases));
    print_rows("BRINDLE_SURFACE_COPIED", s.mesh.positions);
    print_rows("BRINDLE_SURFACE_COPIED", s.mesh.triangles);
    print_rows("BRINDLE_SURFACE_COPIED", s.normals);
    print_list("BRINDLE_SURFACE_COPIED", s.creases.copied);
    print_patterns(s, 9);
    print_frames(s, 9);
    if (shape[0] == 't') print_textures(s, 9);
  }
}
