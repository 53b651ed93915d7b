// What the library makes of a few surfaces, every bit of it as a number. Builds with and without
// vectors and all processors must print the same (tests/scripts/processors_test.py, .ci/run).
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <brindle/brindle.h>

namespace {

/// FNV-1a.
class Fingerprint {
 public:
  template <class Item>
  Fingerprint& add(const std::vector<Item>& items) {
    return add(std::span<const Item>(items));
  }
  template <class Item>
  Fingerprint& add(std::span<const Item> items) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(items.data());
    for (std::size_t i = 0; i < items.size_bytes(); ++i) number_ = (number_ ^ bytes[i]) * kPrime;
    return *this;
  }
  Fingerprint& add(double value) { return add(std::span<const double>(&value, 1)); }
  Fingerprint& add(const brindle::PatternQuality& quality) {
    return add(quality.angle_error_mean_deg).add(quality.spacing_error_mean);
  }
  Fingerprint& add(std::span<const brindle::CornerPhases> corners) {
    for (const brindle::CornerPhases& c : corners) add(std::span<const float>(c.phase));
    return *this;
  }
  Fingerprint& add(const brindle::TextureQuality& quality) {
    return add(quality.angle_mean_deg).add(quality.angle_95th_deg);
  }
  std::uint64_t number() const { return number_; }

 private:
  static constexpr std::uint64_t kPrime = 0x100000001b3;
  std::uint64_t number_ = 0xcbf29ce484222325;
};

void print(const std::string& name, const Fingerprint& fingerprint) {
  std::printf("%-44s %016llx\n", name.c_str(),
              static_cast<unsigned long long>(fingerprint.number()));
}

void print(const std::string& name, const brindle::StripePattern& pattern) {
  std::printf("%-44s %016llx %.17g %zu\n", name.c_str(),
              static_cast<unsigned long long>(Fingerprint()
                                                  .add(pattern.solution.z)
                                                  .add(pattern.waves.frequencies)
                                                  .add(pattern.corners)
                                                  .add(pattern.quality)
                                                  .number()),
              pattern.solution.energy, pattern.quality.branches);
}

struct Input {
  brindle::Surface surface;
  brindle::WaveSet waves;
};

/// With a vector along no symmetry of any shape.
Input input(const std::string& shape, float stripes) {
  brindle::Surface surface = brindle::make_surface(brindle::make_shape(shape));
  const float frequency = stripes / bounding_box(surface.mesh).diagonal();
  brindle::WaveSet waves{surface.mesh.positions,
                         brindle::projected_direction_field({0.31f, 0.9f, 0.27f}, surface.normals),
                         brindle::constant_frequency_field(frequency, surface.mesh.vertex_count())};
  return {std::move(surface), std::move(waves)};
}

void shapes() {
  // Implicit functions take long on a processor that is acted.
  const std::vector<std::string> implicit = {"vessels", "molecule", "box"};
  for (std::string name : brindle::shape_names()) {
    if (std::find(implicit.begin(), implicit.end(), name) != implicit.end())
      name += ",resolution=20";
    print(name, Fingerprint().add(brindle::make_shape(name).positions));
  }
}

void solvers() {
  for (const std::string shape : {"torus,resolution=40", "trefoil,resolution=28"}) {
    const Input in = input(shape, 40);
    const auto with = [&](const std::string& name, const auto& change) {
      brindle::StripeOptions options;
      change(options);
      print(shape + " " + name, brindle::stripe_pattern(in.surface, in.waves, options));
    };
    using brindle::StripeOptions;
    with("multilevel", [](StripeOptions&) {});
    with("cycles", [](StripeOptions& o) { o.solver.cycles = 2; });
    with("cotangent", [](StripeOptions& o) { o.weights = brindle::EdgeWeights::cotangent; });
    with("trapezoid", [](StripeOptions& o) { o.phase_shift = brindle::PhaseShiftKind::trapezoid; });
    with("common source",
         [](StripeOptions& o) { o.phase_shift = brindle::PhaseShiftKind::common_source; });
    with("slack", [](StripeOptions& o) { o.slack = 0.25f; });
    with("relaxation", [](StripeOptions& o) { o.solver.solver = brindle::Solver::relaxation; });
    with("averaged", [](StripeOptions& o) { o.solver.solver = brindle::Solver::averaged; });
  }
}

void fields() {
  const Input in = input("mobius,resolution=28", 20);
  for (const int symmetry : {1, 2, 4}) {
    const auto field = brindle::smooth_direction_field(in.surface, {.symmetry = symmetry});
    print("smooth " + std::to_string(symmetry), Fingerprint().add(field));
  }
  const brindle::Surface box = brindle::make_surface(brindle::make_shape("box,resolution=16"));
  const std::vector<brindle::FieldStroke> strokes = {
      {{{-0.4, 0.1, 0.5}, {0.1, -0.2, 0.5}, {0.4, 0.3, 0.5}}, 0.3, 1}};
  brindle::SmoothFieldOptions options{.symmetry = 4, .feature_anchor = 1};
  options.anchors = brindle::stroke_anchors(box, strokes);
  print("features and strokes", Fingerprint().add(brindle::smooth_direction_field(box, options)));
  const auto curvatures = brindle::principal_curvatures(
      in.surface.mesh.positions, in.surface.normals, *in.surface.neighborhood);
  print("curvature", Fingerprint().add(brindle::curvature_direction_field(
                         curvatures, brindle::CurvatureDirection::maximum)));
}

void frames() {
  const Input in = input("torus,resolution=36", 30);
  for (const float slack : {0.0f, 0.25f}) {
    brindle::AnimatorOptions options;
    options.slack = slack;
    brindle::StripeAnimator animator(in.surface, options);
    brindle::TextureAnimator textures(in.surface);
    Fingerprint stripes, corners;
    for (int number = 0; number < 5; ++number) {
      const auto turned = brindle::rotated(in.waves.directions, in.surface.normals,
                                           0.1f * static_cast<float>(number));
      const brindle::FrameInput frame{in.waves.positions, turned, in.waves.frequencies};
      stripes.add(animator.frame(frame).z).add(animator.energy());
      const auto texture = textures.frame({frame, {}, {}});
      const brindle::TexturePattern& pattern = texture.pattern;
      corners.add(pattern.u.corners).add(pattern.v.corners).add(pattern.quality);
    }
    print(slack > 0 ? "frames with slack" : "frames", stripes);
    print("frames of textures", corners);
  }
}

void textures_and_crosses() {
  const Input in = input("torus,resolution=36", 30);
  const brindle::TexturePattern texture = brindle::texture_pattern(in.surface, in.waves);
  print("texture u", texture.u);
  print("texture v", texture.v);
  const brindle::TexturedMesh textured =
      brindle::texture_coordinates(in.surface.mesh, texture.waves, texture.phase_shift);
  Fingerprint coordinates;
  coordinates.add(texture.quality);
  for (const auto& uv : textured.coordinates) {
    coordinates.add(std::span<const float>(uv.data(), uv.size()));
  }
  print("texture coordinates", coordinates);
  try {
    Fingerprint samples;
    for (const brindle::Sample& s : brindle::stripe_samples(in.surface, texture.u, texture.v)) {
      samples.add(std::span<const float>(s.position.data(), 3));
    }
    print("samples", samples);
  } catch (const brindle::Error& error) {
    // A build that finds no points near points has no samples.
    std::fprintf(stderr, "no samples: %s\n", error.what());
  }

  const brindle::Surface box = brindle::make_surface(brindle::make_shape("box,resolution=16"));
  brindle::WaveSet waves{box.mesh.positions, brindle::smooth_direction_field(box, {.symmetry = 4}),
                         brindle::constant_frequency_field(16, box.mesh.vertex_count())};
  const brindle::CrossPattern cross = brindle::cross_pattern(box, waves);
  print("cross", cross.pattern);
  print("cross texture", Fingerprint().add(brindle::cross_texture(box, cross).pattern.quality));
  brindle::CrossAnimator animator(box);
  Fingerprint crosses;
  for (int number = 0; number < 3; ++number) {
    const auto turned =
        brindle::rotated(waves.directions, box.normals, 0.1f * static_cast<float>(number));
    crosses.add(animator.frame({{box.mesh.positions, turned, waves.frequencies}, {}}).stripes.z);
  }
  print("frames of crosses", crosses);
}

void curves() {
  const Input in = input("torus,resolution=36", 30);
  brindle::StripePattern pattern = brindle::stripe_pattern(in.surface, in.waves);
  const brindle::StripeCurves lines = brindle::stripe_curves(in.surface, pattern);
  print("curves", Fingerprint().add(lines.lines.points));
  brindle::cancel_branches(in.surface, pattern, {0.05});
  print("merged branches", pattern);

  const Input tube = input("tube,bend=0,bulge=0.4", 20);
  const auto curvatures = brindle::principal_curvatures(
      tube.surface.mesh.positions, tube.surface.normals, *tube.surface.neighborhood);
  const brindle::StripePattern rings = brindle::stripe_pattern(
      tube.surface, curvature_direction_field(curvatures, brindle::CurvatureDirection::minimum),
      20);
  const std::vector<brindle::WantedWinding> one = {{"", 1}};
  print("spiral", brindle::wind(tube.surface, rings, one).pattern);
}

}  // namespace

int main() try {
  shapes();
  solvers();
  fields();
  frames();
  textures_and_crosses();
  curves();
} catch (const brindle::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
