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
  std::vector<CornerSigns> signs;
  corner_signs(triangles, pattern.u.waves.directions, pattern.v.waves.directions, signs);
  const std::vector<SharedEdge> edges = shared_edges(triangles);
  const std::vector<std::uint8_t> oriented = oriented_triangles(signs);
  std::vector<EdgeAgreement> agreement;
  agreements(signs, edges, agreement);
  if (!as_given) {
    const auto turned = orienting_turns(triangles, oriented, edges, agreement, progress);
    turn_agreements(turned, edges, agreement);
    turn_signs(turned, signs);
  }
  pattern.seams = texture_seams(oriented, agreement);
  set_texture_waves(triangles, signs, vertex_waves(pattern.u), vertex_waves(pattern.v),
                    pattern.waves);
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
  pattern.u = stripe_pattern(surface, std::move(waves), options.stripes, progress);
  pattern.v = stripe_pattern(surface, std::move(waves_v), options.stripes, progress);

  Stopwatch watch;
  progress.report("texture", 0);
  orient(surface.mesh.triangles, options.oriented, progress, pattern);
  pattern.quality =
      measure_texture(surface.mesh, linear_pattern(pattern.u), linear_pattern(pattern.v));
  pattern.orientation_milliseconds = watch.lap();
  return pattern;
}

TexturePattern texture_pattern(const Surface& surface, DirectionField field, float frequency,
                               const TextureOptions& options, const Progress& progress) {
  return texture_pattern(surface,
                         {surface.mesh.positions, std::move(field),
                          constant_frequency_field(frequency, surface.mesh.vertex_count())},
                         options, progress);
}

TexturedMesh texture_coordinates(const Surface& surface, const TexturePattern& pattern) {
  check_fits(surface, pattern.waves.triangle_count(), "texture");
  return texture_coordinates(surface.mesh, pattern.waves, pattern.phase_shift);
}

TexturedMesh texture_coordinates(const Surface& surface, const StripePattern& pattern,
                                 PhaseShiftKind phase_shift, bool oriented) {
  check_fits(surface, pattern.corners.size(), "pattern");
  const std::vector<Complex> crest(pattern.solution.z.size(), Complex(0, 1));
  TextureWaves waves = texture_waves(surface.mesh.triangles, pattern.waves, pattern.solution.z,
                                     level_waves(pattern.waves), crest);
  orient_corners(waves);
  if (!oriented) {
    orient_triangles(waves, surface.mesh.triangles, shared_edges(surface.mesh.triangles));
  }
  return texture_coordinates(surface.mesh, waves, phase_shift);
}

}  // namespace brindle
