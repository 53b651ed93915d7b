#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/cross_texture.h"
#include "brindle/error.h"

namespace brindle {
namespace {

PatternQuality quality_of(const CrossCover& cover, const StripePattern& pattern) {
  PatternQuality quality = pattern.quality;
  const std::size_t pairs = cover.base.size();
  quality.vertices_without_wave /= 2;  // each vertex is two nodes
  quality.branches += 2 * cover.singular.size();
  quality.field_singularities = cover.singular.size();
  for (std::size_t s = 0; s < pairs; ++s) {
    quality.field_singularities +=
        pattern.corners[s].kind == TriangleKind::field_singularity ||
        pattern.corners[pairs + s].kind == TriangleKind::field_singularity;
  }
  return quality;
}

/// Both waves of a vertex have what the vertex has.
std::vector<float> by_node(const std::vector<float>& by_vertex) {
  std::vector<float> nodes;
  nodes.reserve(2 * by_vertex.size());
  for (const float number : by_vertex) nodes.insert(nodes.end(), 2, number);
  return nodes;
}

StripeOptions options_on_cover(StripeOptions options) {
  options.slack.by_vertex = by_node(options.slack.by_vertex);
  options.slack.calm = by_node(options.slack.calm);
  return options;
}

/// The triangles that the cover leaves out count twice, as in `branches`.
void add_singular_in_calm(std::span<const Triangle> triangles, const CrossCover& cover,
                          std::span<const float> calm, PatternQuality& quality) {
  if (!quality.branches_in_calm) return;
  for (const Index t : cover.singular) {
    const auto& [a, b, c] = triangles[t];
    *quality.branches_in_calm += calm[a] + calm[b] + calm[c] >= 1.5f ? 2 : 0;
  }
}

}  // namespace

Surface cover_surface(const CrossCover& cover, std::span<const Vec3> normals) {
  Surface surface{{cover.waves.positions, cover.triangles}, cover.neighborhood, {}};
  surface.normals.reserve(2 * normals.size());
  for (const Vec3& normal : normals) surface.normals.insert(surface.normals.end(), 2, normal);
  return surface;
}

CrossPattern cross_pattern(const Surface& surface, const WaveSet& waves,
                           const StripeOptions& options, const Progress& progress) {
  check_tangent_waves(surface, waves);
  Stopwatch watch;
  progress.report("match crosses", 0);
  CrossPattern result;
  result.cover = cross_cover(*surface.neighborhood, surface.mesh.triangles,
                             cross_waves(waves, surface.normals));
  result.surface = cover_surface(result.cover, surface.normals);
  const double matching = watch.lap();
  check(options.slack, surface.mesh.vertex_count());
  result.pattern =
      stripe_pattern(result.surface, result.cover.waves, options_on_cover(options), progress);
  result.cover.waves.frequencies = result.pattern.waves.frequencies;
  result.pattern.milliseconds.couple += matching;
  result.quality = quality_of(result.cover, result.pattern);
  add_singular_in_calm(surface.mesh.triangles, result.cover, options.slack.calm, result.quality);
  return result;
}

}  // namespace brindle
