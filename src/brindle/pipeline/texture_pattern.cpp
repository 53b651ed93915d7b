#include "brindle/texture_pattern.h"

#include <numbers>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/pipeline/measured_pattern.h"

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

void check_vertices(const Surface& surface, const StripePattern& pattern) {
  const WaveSet& waves = pattern.waves;
  for (const std::size_t entries : {waves.positions.size(), waves.directions.size(),
                                    waves.frequencies.size(), pattern.solution.z.size()}) {
    if (entries == surface.mesh.vertex_count()) continue;
    throw Error("texture: there are waves or phases of " + std::to_string(entries) +
                " vertices for " + std::to_string(surface.mesh.vertex_count()));
  }
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
  orient_texture(surface.mesh, options.oriented, stages.begin("texture"), pattern);
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
  check_vertices(surface, pattern);
  JobStages stages(progress, {{"orient", 1}, {"coordinates", 2}});
  const Progress orienting = stages.begin("orient");
  const std::vector<Triangle>& triangles = surface.mesh.triangles;
  TextureOrientation orientation(triangles);
  orientation.follow(pattern.waves.directions, pattern.waves.directions, oriented, orienting);
  const WaveSet& u = pattern.waves;
  // V has no stripes: its phase is that of a crest, which is invariant under reversal.
  const FrequencyField level(u.frequencies.size());
  const std::vector<Complex> crest(pattern.solution.z.size(), Complex(0, 1));
  TextureWaves waves;
  set_texture_waves(triangles, orientation.signs(),
                    {u.positions, u.directions, u.frequencies, pattern.solution.z},
                    {u.positions, u.directions, level, crest}, waves, orienting.part(1, 1));
  TexturedMesh textured =
      texture_coordinates(surface.mesh, waves, phase_shift, stages.begin("coordinates"));
  stages.finish();
  return textured;
}

}  // namespace brindle
