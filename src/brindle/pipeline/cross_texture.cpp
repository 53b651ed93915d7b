#include "brindle/cross_texture.h"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/normals.h"
#include "brindle/pattern/corner_signs.h"
#include "brindle/pattern/quality_sums.h"
#include "brindle/pipeline/cross_parts.h"
#include "brindle/waves/wave_check.h"

namespace brindle {

Surface cover_surface(const CrossCover& cover, std::span<const Vec3> normals) {
  Surface surface{{cover.waves.positions, cover.triangles}, cover.neighborhood, {}};
  surface.normals.reserve(2 * normals.size());
  for (const Vec3& normal : normals) surface.normals.insert(surface.normals.end(), 2, normal);
  return surface;
}

CrossPattern cross_pattern(const Surface& surface, const WaveSet& waves,
                           const StripeOptions& options, const Progress& progress) {
  check_tangent_waves(surface, waves);
  JobStages stages(progress, {{"match crosses", 2}, {"stripes", 10}});
  Stopwatch watch;
  const Progress matching_stage = stages.begin("match crosses");
  CrossPattern result;
  result.cover = cross_cover(*surface.neighborhood, surface.mesh.triangles,
                             cross_waves(waves, surface.normals), matching_stage.part(0, 0.8));
  matching_stage.report(0.8);
  result.surface = cover_surface(result.cover, surface.normals);
  result.surface.mesh.origin = surface.mesh.origin;
  const double matching = watch.lap();
  check_slack(options.slack, surface.mesh.vertex_count());
  StripeOptions on_cover = options;
  on_cover.slack = slack_on_cover(options.slack);
  result.pattern =
      stripe_pattern(result.surface, result.cover.waves, on_cover, stages.begin("stripes"));
  result.cover.waves.frequencies = result.pattern.waves.frequencies;
  result.pattern.milliseconds.couple += matching;
  result.quality = cross_quality(surface.mesh.triangles, result, options.slack.branch_penalty);
  stages.finish();
  return result;
}

namespace {

/// The waves (i, r) of all vertices i with the pattern's metrics. Added vertices have no wave.
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

/// Computes corner phases and quality. Added triangles (from `regular` on) are always marked
/// singular.
void measure(const Mesh& mesh, std::size_t regular, const Progress& progress,
             TexturePattern& pattern) {
  const PhaseShiftKind kind = pattern.phase_shift;
  pattern.u.corners = corner_phases(pattern.waves.u, kind, progress.part(0, 0.3));
  pattern.v.corners = corner_phases(pattern.waves.v, kind, progress.part(0.3, 0.6));
  for (StripePattern* part : {&pattern.u, &pattern.v}) {
    for (std::size_t t = regular; t < part->corners.size(); ++t) {
      part->corners[t].kind = TriangleKind::field_singularity;
    }
  }
  pattern.quality =
      measure_texture(mesh, {pattern.u.corners, pattern.u.waves.frequencies},
                      {pattern.v.corners, pattern.v.waves.frequencies}, progress.part(0.6, 1));
}

}  // namespace

CrossTexture cross_texture(const Surface& surface, const CrossPattern& cross,
                           PhaseShiftKind phase_shift, const Progress& progress) {
  JobStages stages(progress, {{"texture", 3}, {"surface", 3}, {"measure", 3}});
  Stopwatch watch;
  CrossParts parts = cross_parts(surface.mesh, cross.cover, cross.pattern.solution.z, phase_shift,
                                 {}, stages.begin("texture"));
  CrossTexture texture;
  texture.surface = make_surface(std::move(parts.mesh), stages.begin("surface"));
  TexturePattern& pattern = texture.pattern;
  pattern.waves = std::move(parts.waves);
  pattern.phase_shift = phase_shift;
  const Progress measuring = stages.begin("measure");
  pattern.u = pattern_of(cross, 0, texture.surface.mesh.positions);
  pattern.v = pattern_of(cross, 1, texture.surface.mesh.positions);
  measure(texture.surface.mesh, cross.cover.base.size(), measuring, pattern);
  pattern.u.milliseconds = cross.pattern.milliseconds;
  pattern.orientation_milliseconds = watch.lap();
  stages.finish();
  return texture;
}

namespace {

/// Repeats each vertex entry for its two nodes.
std::vector<float> by_node(const std::vector<float>& by_vertex) {
  std::vector<float> nodes;
  nodes.reserve(2 * by_vertex.size());
  for (const float number : by_vertex) nodes.insert(nodes.end(), 2, number);
  return nodes;
}

/// Continues two matching waves to the point `point`, for which it averages them.
CornerWave continued(const CornerWave& a, CornerWave b, const Vec3& point, PhaseShiftKind kind) {
  if (a.wave.direction.dot(b.wave.direction) < 0) b = flipped(b);
  CornerWave result{{point, Vec3(a.wave.direction + b.wave.direction).normalized(),
                     (a.wave.frequency + b.wave.frequency) / 2},
                    0};
  for (const CornerWave& from : {a, b}) {
    result.z += from.z * elementary::polar(1.0f, phase_shift(kind, from.wave, result.wave).radians);
  }
  const float length = std::abs(result.z);
  result.z = length > 0 ? result.z / length : Complex(1);
  return result;
}

/// The triangles of a cross texture and the waves at their corners.
class CrossTriangles {
 public:
  CrossTriangles(const Mesh& mesh, const CrossCover& cover, std::span<const Complex> z,
                 PhaseShiftKind kind, CrossParts last, const Progress& progress)
      : cover_(cover),
        z_(z),
        kind_(kind),
        mesh_(std::move(last.mesh)),
        waves_(std::move(last.waves)) {
    mesh_.positions = mesh.positions;
    mesh_.origin = mesh.origin;
    mesh_.positions.reserve(mesh.vertex_count() + cover.singular.size());
    add_matching(mesh, progress);
    for (const Index t : cover.singular) split(mesh.triangles[t]);
  }

  CrossParts take() { return {std::move(mesh_), std::move(waves_)}; }

 private:
  /// Triangles around which crosses match. Reserves memory for the parts of the others.
  void add_matching(const Mesh& mesh, const Progress& progress) {
    const std::size_t count = cover_.base.size();
    const std::size_t room = count + 3 * cover_.singular.size();
    mesh_.triangles.reserve(room);
    waves_.u.reserve(room);
    waves_.v.reserve(room);
    mesh_.triangles.resize(count);
    waves_.u.resize(count);
    progress.tick();
    waves_.v.resize(count);
    parallel_for(count, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        mesh_.triangles[s] = mesh.triangles[cover_.base[s]];
        waves_.u[s] = corner_waves(cover_.u()[s], cover_.waves, z_);
        waves_.v[s] = corner_waves(cover_.v()[s], cover_.waves, z_);
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
    const Index node_a = 2 * a, node_b = 2 * b + matching_wave(cover_.waves, a, b);
    add({a, b, middle}, part_waves(node_a, node_b, middle),
        part_waves(other_wave(node_a), other_wave(node_b), middle));
  }

  CornerWave wave_of(Index node) const { return {cover_.waves.wave(node), z_[node]}; }

  CornerWaves part_waves(Index node_a, Index node_b, Index middle) const {
    const CornerWave a = wave_of(node_a), b = wave_of(node_b);
    return {a, b, continued(a, b, mesh_.positions[middle], kind_)};
  }

  const CrossCover& cover_;
  std::span<const Complex> z_;
  PhaseShiftKind kind_;
  Mesh mesh_;
  TextureWaves waves_;
};

/// Reverses V where it points to the right of U, viewed from outside: otherwise the tile image
/// would be mirrored.
void turn_left(const Mesh& mesh, TextureWaves& waves, const Progress& progress) {
  parallel_for(mesh.triangle_count(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      Vec3 turn = Vec3::Zero();
      for (int m = 0; m < 3; ++m) {
        turn += waves.u[t][m].wave.direction.cross(waves.v[t][m].wave.direction);
      }
      if (turn.dot(triangle_normal(mesh, mesh.triangles[t])) < 0) turn_round(waves.v[t]);
    }
  });
}

}  // namespace

CrossParts cross_parts(const Mesh& mesh, const CrossCover& cover, std::span<const Complex> z,
                       PhaseShiftKind kind, CrossParts last, const Progress& progress) {
  CrossParts parts =
      CrossTriangles(mesh, cover, z, kind, std::move(last), progress.part(0, 0.4)).take();
  orient_corners(parts.waves, progress.part(0.4, 0.7));
  turn_left(parts.mesh, parts.waves, progress.part(0.7, 1));
  return parts;
}

Slack slack_on_cover(Slack slack) {
  slack.by_vertex = by_node(slack.by_vertex);
  slack.branch_penalty = by_node(slack.branch_penalty);
  return slack;
}

PatternQuality cross_quality(const CrossCover& cover, PatternQuality on_cover,
                             std::span<const CornerPhases> corners) {
  PatternQuality quality = std::move(on_cover);
  const std::size_t pairs = cover.base.size();
  quality.vertices_without_wave /= 2;  // each vertex is two nodes
  quality.branches += 2 * cover.singular.size();
  quality.field_singularities = cover.singular.size();
  for (std::size_t s = 0; s < pairs; ++s) {
    quality.field_singularities += corners[s].kind == TriangleKind::field_singularity ||
                                   corners[pairs + s].kind == TriangleKind::field_singularity;
  }
  return quality;
}

PatternQuality cross_quality(std::span<const Triangle> triangles, const CrossPattern& cross,
                             std::span<const float> branch_penalty) {
  PatternQuality quality = cross_quality(cross.cover, cross.pattern.quality, cross.pattern.corners);
  if (!quality.branches_in_avoided_area) return quality;
  // Singular triangles count twice, as in `branches`.
  for (const Index t : cross.cover.singular) {
    const auto& [a, b, c] = triangles[t];
    *quality.branches_in_avoided_area +=
        branch_penalty[a] + branch_penalty[b] + branch_penalty[c] >= 1.5f ? 2 : 0;
  }
  return quality;
}

}  // namespace brindle
