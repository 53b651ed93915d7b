#include "brindle/cross_texture.h"

#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
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

}  // namespace brindle
