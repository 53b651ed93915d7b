#include "wave_settings.h"

#include <numbers>
#include <utility>

#include <brindle/error.h>
#include <brindle/frequency_field.h>
#include <brindle/smooth_field.h>

namespace brindle::paraview {
namespace {

constexpr float kCurvatureAnchor = 0.1f;  // as `brindle stripe --field curvature` has it

DirectionField array_directions(const Surface& surface, const WaveSettings& settings,
                                const DataArray* vectors) {
  if (vectors == nullptr) throw Error("choose an array of vectors for the field");
  if (!is_tensor(*vectors)) return direction_field_of(surface, *vectors);
  return tensor_field_of(surface, *vectors, settings.tensor_axis).directions;
}

FrequencyField make_frequencies(const Surface& surface, const WaveSettings& settings,
                                const DirectionField& directions, const DataArray* frequencies) {
  const auto along_diagonal = [&] {
    return frequency_of_stripes(settings.stripes, bounding_box(surface.mesh).diagonal());
  };
  if (settings.needs_frequency_array() && frequencies == nullptr) {
    throw Error("choose an array for the frequency");
  }
  switch (settings.frequency_source) {
    case FrequencySource::array:
      return frequencies_of(*frequencies, directions);
    case FrequencySource::by_array:
      return frequencies_by(surface, *frequencies, along_diagonal(), settings.range);
    case FrequencySource::per_length:
      return constant_frequency_field(settings.frequency, surface.mesh.vertex_count());
    case FrequencySource::along_diagonal:
      break;
  }
  return constant_frequency_field(along_diagonal(), surface.mesh.vertex_count());
}

}  // namespace

DirectionField made_directions(const Surface& surface, const WaveSettings& settings) {
  SmoothFieldOptions options;
  if (settings.field == FieldSource::curvature) options.curvature_anchor = kCurvatureAnchor;
  options.curvature_direction = settings.curvature_direction;
  return smooth_direction_field(surface, options);
}

WaveSet make_waves(const Surface& surface, const WaveSettings& settings, DirectionField made,
                   const DataArray* vectors, const DataArray* frequencies) {
  DirectionField directions = std::move(made);
  if (settings.field == FieldSource::direction) {
    directions = projected_direction_field(settings.direction, surface.normals);
  } else if (settings.field == FieldSource::array) {
    directions = array_directions(surface, settings, vectors);
  }
  if (settings.turn_deg != 0) {
    directions =
        rotated(directions, surface.normals, settings.turn_deg * std::numbers::pi_v<float> / 180);
  }
  FrequencyField chosen = make_frequencies(surface, settings, directions, frequencies);
  if (settings.needs_frequency_array()) drop_waves_without_frequency(directions, chosen);
  return {surface.mesh.positions, std::move(directions), std::move(chosen)};
}

}  // namespace brindle::paraview
