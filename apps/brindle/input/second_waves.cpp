#include "input/second_waves.h"

#include <numbers>
#include <utility>

#include "brindle/direction_field.h"
#include "brindle/files.h"
#include "brindle/frequency_field.h"
#include "brindle/windings.h"
#include "input/csv_field.h"

namespace brindle::tool {

FirstWaves first_waves(const Preparation& prepared) {
  return {prepared.surface, prepared.waves, prepared.frequencies_v, prepared.vertex_of_row,
          prepared.metrics.subdivided};
}

WaveSet make_second_waves(const FirstWaves& first, const SecondWaveOptions& options,
                          JobListener& listener) {
  const Surface& surface = first.surface;
  WaveSet waves{first.waves.positions, {}, first.frequencies_v};
  if (waves.frequencies.empty()) waves.frequencies = first.waves.frequencies;
  if (options.field.empty()) {
    waves.directions =
        rotated(first.waves.directions, surface.normals, std::numbers::pi_v<float> / 2);
  } else {
    FieldFile file = read_rows(surface, options.field, first.vertex_of_row);
    waves.directions = tangent_directions(file.vectors, surface.normals);
    if (!file.frequencies.empty()) waves.frequencies = std::move(file.frequencies);
  }
  std::optional<float> frequency = options.frequency;
  if (options.stripes) {
    frequency = frequency_of_stripes(*options.stripes, bounding_box(surface.mesh).diagonal());
  }
  if (frequency) {
    waves.frequencies = constant_frequency_field(*frequency, surface.mesh.vertex_count());
  }
  if (options.wales.periods > 0) waves = waves_round(surface, waves.directions, options.wales);
  WaveReport known;
  known.subdivided = first.subdivided;
  if (is_other(options))
    noted_waves(measure_waves(surface, waves), "the field of V", listener, known);
  return waves;
}

}  // namespace brindle::tool
