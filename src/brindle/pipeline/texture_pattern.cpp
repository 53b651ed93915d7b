#include "brindle/texture_pattern.h"

#include <numbers>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/pattern/texture_quality.h"
#include "brindle/pipeline/texture_orientation.h"

namespace brindle {
namespace {

/// The waves turned by 90 degrees about the normals.
WaveSet orthogonal_waves(const Surface& surface, const WaveSet& waves,
                         const FrequencyField& frequencies) {
  return {waves.positions,
          rotated(waves.directions, surface.normals, std::numbers::pi_v<float> / 2),
          frequencies.empty() ? waves.frequencies : frequencies};
}

void check_fits(const Surface& surface, std::size_t triangles, const char* what) {
  if (triangles == surface.mesh.triangle_count()) return;
  throw Error(std::string("a ") + what + " of " + std::to_string(triangles) +
              " triangles was not made for a surface of " +
              std::to_string(surface.mesh.triangle_count()));
}

VertexWaves vertex_waves(const StripePattern& pattern) {
  return {pattern.waves.positions, pattern.waves.directions, pattern.waves.frequencies,
          pattern.solution.z};
}

LinearPattern linear_pattern(const StripePattern& pattern) {
  return {pattern.corners, pattern.waves.frequencies};
}

/// Waves, oriented, and seams from both patterns.
void orient(std::span<const Triangle> triangles, bool as_given, const Progress& progress,
            TexturePattern& pattern) {
  progress.report(0);
  std::vector<CornerSigns> signs;
  corner_signs(triangles, pattern.u.waves.directions, pattern.v.waves.directions, signs);
  progress.report(0.1);
  const std::vector<SharedEdge> edges = shared_edges(triangles);
  progress.report(0.3);
  const std::vector<std::uint8_t> oriented = oriented_triangles(signs);
  std::vector<EdgeAgreement> agreement;
  agreements(signs, edges, agreement);
  if (!as_given) {
    const auto turned =
        orienting_turns(triangles, oriented, edges, agreement, progress.part(0.3, 0.8));
    turn_agreements(turned, edges, agreement);
    turn_signs(turned, signs);
  }
  progress.report(0.8);
  pattern.seams = texture_seams(oriented, agreement);
  progress.report(0.9);
  set_texture_waves(triangles, signs, vertex_waves(pattern.u), vertex_waves(pattern.v),
                    pattern.waves, progress.part(0.9, 1));
}

/// Waves without stripes. Their phase is that of a crest: the same whichever way they run.
WaveSet level_waves(const WaveSet& waves) {
  return {waves.positions, waves.directions, FrequencyField(waves.frequencies.size())};
}

}  // namespace

TexturePattern texture_pattern(const Surface& surface, WaveSet waves, const TextureOptions& options,
                               const Progress& progress) {
  check_tangent_waves(surface, waves);
  TexturePattern pattern;
  pattern.phase_shift = options.stripes.phase_shift;
  WaveSet waves_v = orthogonal_waves(surface, waves, options.frequencies_v);
  JobStages stages(progress, {{"stripes of U", 4}, {"stripes of V", 4}, {"texture", 5}});
  pattern.u =
      stripe_pattern(surface, std::move(waves), options.stripes, stages.begin("stripes of U"));
  pattern.v =
      stripe_pattern(surface, std::move(waves_v), options.stripes, stages.begin("stripes of V"));

  Stopwatch watch;
  const Progress texture = stages.begin("texture");
  orient(surface.mesh.triangles, options.oriented, texture.part(0, 0.9), pattern);
  texture.report(0.9);
  pattern.quality = measure_texture(surface.mesh, linear_pattern(pattern.u),
                                    linear_pattern(pattern.v), texture.part(0.9, 1));
  pattern.orientation_milliseconds = watch.lap();
  stages.finish();
  return pattern;
}

TexturePattern texture_pattern(const Surface& surface, DirectionField field, float frequency,
                               const TextureOptions& options, const Progress& progress) {
  return texture_pattern(surface,
                         {surface.mesh.positions, std::move(field),
                          constant_frequency_field(frequency, surface.mesh.vertex_count())},
                         options, progress);
}

TexturedMesh texture_coordinates(const Surface& surface, const TexturePattern& pattern,
                                 const Progress& progress) {
  check_fits(surface, pattern.waves.triangle_count(), "texture");
  return texture_coordinates(surface.mesh, pattern.waves, pattern.phase_shift, progress);
}

TexturedMesh texture_coordinates(const Surface& surface, const StripePattern& pattern,
                                 PhaseShiftKind phase_shift, bool oriented,
                                 const Progress& progress) {
  check_fits(surface, pattern.corners.size(), "pattern");
  JobStages stages(progress, {{"orient", 1}, {"coordinates", 2}});
  const Progress orienting = stages.begin("orient");
  const std::vector<Complex> crest(pattern.solution.z.size(), Complex(0, 1));
  TextureWaves waves = texture_waves(surface.mesh.triangles, pattern.waves, pattern.solution.z,
                                     level_waves(pattern.waves), crest);
  orient_corners(waves);
  if (!oriented) {
    orienting.report(0.1);
    orient_triangles(waves, surface.mesh.triangles, shared_edges(surface.mesh.triangles),
                     orienting.part(0.2, 1));
  }
  TexturedMesh textured =
      texture_coordinates(surface.mesh, waves, phase_shift, stages.begin("coordinates"));
  stages.finish();
  return textured;
}

}  // namespace brindle
