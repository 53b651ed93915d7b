#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/cross_texture.h"
#include "brindle/error.h"
#include "brindle/pipeline/cross_parts.h"
#include "brindle/waves/slack_check.h"

namespace brindle {
namespace {

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
  JobStages stages(progress, {{"match crosses", 2}, {"stripes", 10}});
  Stopwatch watch;
  const Progress matching_stage = stages.begin("match crosses");
  CrossPattern result;
  result.cover = cross_cover(*surface.neighborhood, surface.mesh.triangles,
                             cross_waves(waves, surface.normals), matching_stage.part(0, 0.8));
  matching_stage.report(0.8);
  result.surface = cover_surface(result.cover, surface.normals);
  const double matching = watch.lap();
  check_slack(options.slack, surface.mesh.vertex_count());
  StripeOptions on_cover = options;
  on_cover.slack = slack_on_cover(options.slack);
  result.pattern =
      stripe_pattern(result.surface, result.cover.waves, on_cover, stages.begin("stripes"));
  result.cover.waves.frequencies = result.pattern.waves.frequencies;
  result.pattern.milliseconds.couple += matching;
  result.quality = cross_quality(result.cover, result.pattern.quality, result.pattern.corners);
  add_singular_in_calm(surface.mesh.triangles, result.cover, options.slack.calm, result.quality);
  stages.finish();
  return result;
}

}  // namespace brindle
