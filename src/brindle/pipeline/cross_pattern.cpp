
#include "brindle/base/stopwatch.h"
#include "brindle/cross_texture.h"
#include "brindle/error.h"
#include "brindle/pipeline/cross_parts.h"
#include "brindle/waves/slack_check.h"

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

}  // namespace brindle
