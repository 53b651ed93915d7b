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
  result.pattern = stripe_pattern(result.surface, result.cover.waves, options, progress);
  result.pattern.milliseconds.couple += matching;
  result.quality = quality_of(result.cover, result.pattern);
  return result;
}

}  // namespace brindle
