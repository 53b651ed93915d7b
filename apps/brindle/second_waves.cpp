#include "second_waves.h"

#include <numbers>
#include <utility>

#include "brindle/waves/direction_field.h"
#include "brindle/waves/frequency_field.h"
#include "option_values.h"

namespace brindle::tool {

void add_second_wave_options(CLI::App& app, SecondWaveOptions& options) {
  app.add_option("--field-v", options.field,
                 "V: a CSV file as for --field (default: U's field turned by 90 degrees)")
      ->type_name("FILE");
  CLI::Option* stripes = add_parsed_option(app, "--stripes-v", options.stripes, positive_number_of,
                                           "V: as --stripes (default: U's frequencies)")
                             ->type_name("N");
  add_parsed_option(app, "--frequency-v", options.frequency, positive_number_of,
                    "V: as --frequency")
      ->type_name("F")
      ->excludes(stripes);
}

WaveSet make_second_waves(const Surface& surface, const WaveSet& first,
                          const SecondWaveOptions& options, std::span<const Index> vertex_of_row) {
  WaveSet waves{first.positions, {}, first.frequencies};
  if (options.field.empty()) {
    waves.directions = rotated(first.directions, surface.normals, std::numbers::pi_v<float> / 2);
  } else {
    FieldFile file = read_field_csv(options.field, surface.mesh.vertex_count(), vertex_of_row);
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
  return waves;
}

}  // namespace brindle::tool
