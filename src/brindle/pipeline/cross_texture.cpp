#include "brindle/cross_texture.h"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/geometry/normals.h"
#include "brindle/pattern/texture_quality.h"

namespace brindle {
namespace {

CornerWave wave_of(const CrossPattern& cross, Index node) {
  const WaveSet& waves = cross.cover.waves;
  return {waves.wave(node), cross.pattern.solution.z[node]};
}

/// The wave that continues both, which belong together, to a point beside them.
CornerWave continued(const CornerWave& a, CornerWave b, const Vec3& point, PhaseShiftKind kind) {
  if (a.wave.direction.dot(b.wave.direction) < 0) b = flipped(b);
  CornerWave result{{point, Vec3(a.wave.direction + b.wave.direction).normalized(),
                     (a.wave.frequency + b.wave.frequency) / 2},
                    0};
  for (const CornerWave& from : {a, b}) {
    result.z += from.z * std::polar(1.0f, phase_shift(kind, from.wave, result.wave).radians);
  }
  const float length = std::abs(result.z);
  result.z = length > 0 ? result.z / length : Complex(1);
  return result;
}

/// The triangles of a cross texture and the waves at their corners.
class CrossTriangles {
 public:
  CrossTriangles(const Mesh& mesh, const CrossPattern& cross, PhaseShiftKind kind)
      : cross_(cross), kind_(kind) {
    mesh_.positions = mesh.positions;
    mesh_.origin = mesh.origin;
    const CrossCover& cover = cross.cover;
    mesh_.positions.reserve(mesh.vertex_count() + cover.singular.size());
    add_matching(mesh);
    for (const Index t : cover.singular) split(mesh.triangles[t]);
  }

  Mesh& mesh() { return mesh_; }
  TextureWaves& waves() { return waves_; }

 private:
  /// The triangles around which crosses match, with room for the parts of the others.
  void add_matching(const Mesh& mesh) {
    const CrossCover& cover = cross_.cover;
    const std::vector<Complex>& z = cross_.pattern.solution.z;
    const std::size_t count = cover.base.size();
    const std::size_t room = count + 3 * cover.singular.size();
    mesh_.triangles.reserve(room);
    waves_.u.reserve(room);
    waves_.v.reserve(room);
    mesh_.triangles.resize(count);
    waves_.u.resize(count);
    waves_.v.resize(count);
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        mesh_.triangles[s] = mesh.triangles[cover.base[s]];
        waves_.u[s] = corner_waves(cover.u()[s], cover.waves, z);
        waves_.v[s] = corner_waves(cover.v()[s], cover.waves, z);
      }
    });
  }

  void add(const Triangle& triangle, const CornerWaves& u, const CornerWaves& v) {
    mesh_.triangles.push_back(triangle);
    waves_.u.push_back(u);
    waves_.v.push_back(v);
  }

  void split(const Triangle& triangle) {
    const auto middle = static_cast<Index>(mesh_.vertex_count());
    const auto& [a, b, c] = triangle;
    const Vec3 first = mesh_.positions[a];
    mesh_.positions.push_back(first +
                              ((mesh_.positions[b] - first) + (mesh_.positions[c] - first)) / 3);
    for (int m = 0; m < 3; ++m) add_part(triangle[m], triangle[(m + 1) % 3], middle);
  }

  void add_part(Index a, Index b, Index middle) {
    const Index node_a = 2 * a, node_b = 2 * b + matching_wave(cross_.cover.waves, a, b);
    add({a, b, middle}, part_waves(node_a, node_b, middle),
        part_waves(other_wave(node_a), other_wave(node_b), middle));
  }

  CornerWaves part_waves(Index node_a, Index node_b, Index middle) const {
    const CornerWave a = wave_of(cross_, node_a), b = wave_of(cross_, node_b);
    return {a, b, continued(a, b, mesh_.positions[middle], kind_)};
  }

  const CrossPattern& cross_;
  PhaseShiftKind kind_;
  Mesh mesh_;
  TextureWaves waves_;
};

/// Turns V round where it runs to the right of U, seen from outside: what a tile's picture shows
/// must not be mirrored.
void turn_left(const Mesh& mesh, TextureWaves& waves) {
  parallel_for(mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      Vec3 turn = Vec3::Zero();
      for (int m = 0; m < 3; ++m) {
        turn += waves.u[t][m].wave.direction.cross(waves.v[t][m].wave.direction);
      }
      if (turn.dot(triangle_normal(mesh, mesh.triangles[t])) < 0) flip(waves.v[t]);
    }
  });
}

/// The waves (i, r) of all vertices i, and none at the others, with the figures of the whole.
StripePattern pattern_of(const CrossPattern& cross, Index r, std::span<const Vec3> positions) {
  StripePattern pattern;
  pattern.waves.positions.assign(positions.begin(), positions.end());
  const FrequencyField& wanted = cross.pattern.frequencies_wanted;
  const std::size_t vertices = cross.cover.waves.positions.size() / 2;
  pattern.waves.directions.reserve(positions.size());
  pattern.waves.frequencies.reserve(positions.size());
  pattern.solution.z.reserve(positions.size());
  for (Index i = 0; i < positions.size(); ++i) {
    const bool is_new = i >= vertices;
    const Index node = is_new ? 0 : 2 * i + r;
    pattern.waves.directions.push_back(is_new ? Vec3(Vec3::Zero())
                                              : cross.cover.waves.directions[node]);
    pattern.waves.frequencies.push_back(cross.cover.waves.frequencies[node]);
    if (!wanted.empty()) pattern.frequencies_wanted.push_back(wanted[node]);
    pattern.solution.z.push_back(is_new ? Complex(1) : cross.pattern.solution.z[node]);
  }
  pattern.solution.energy = cross.pattern.solution.energy;
  pattern.solution.iterations = cross.pattern.solution.iterations;
  pattern.quality = cross.quality;
  pattern.frequency_change = cross.pattern.frequency_change;
  return pattern;
}

/// Corner phases of both patterns, and what is measured of them. New triangles are singular,
/// whatever their corners look like; the texture on them is measured all the same.
void measure(const Mesh& mesh, std::size_t regular, TexturePattern& pattern) {
  pattern.u.corners = corner_phases(pattern.waves.u, pattern.phase_shift);
  pattern.v.corners = corner_phases(pattern.waves.v, pattern.phase_shift);
  pattern.quality = measure_texture(mesh, {pattern.u.corners, pattern.u.waves.frequencies},
                                    {pattern.v.corners, pattern.v.waves.frequencies});
  for (StripePattern* part : {&pattern.u, &pattern.v}) {
    for (std::size_t t = regular; t < part->corners.size(); ++t) {
      part->corners[t].kind = TriangleKind::field_singularity;
    }
  }
}

}  // namespace

CrossTexture cross_texture(const Surface& surface, const CrossPattern& cross,
                           PhaseShiftKind phase_shift) {
  Stopwatch watch;
  CrossTriangles triangles(surface.mesh, cross, phase_shift);
  CrossTexture texture;
  texture.surface = make_surface(std::move(triangles.mesh()));
  TexturePattern& pattern = texture.pattern;
  pattern.waves = std::move(triangles.waves());
  pattern.phase_shift = phase_shift;
  orient_corners(pattern.waves);
  turn_left(texture.surface.mesh, pattern.waves);
  pattern.u = pattern_of(cross, 0, texture.surface.mesh.positions);
  pattern.v = pattern_of(cross, 1, texture.surface.mesh.positions);
  measure(texture.surface.mesh, cross.cover.base.size(), pattern);
  pattern.u.milliseconds = cross.pattern.milliseconds;
  pattern.orientation_milliseconds = watch.lap();
  return texture;
}

}  // namespace brindle
