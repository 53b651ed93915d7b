#include "ranks/piece_frequencies.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "brindle/array_field.h"
#include "brindle/waves/frequency_parts.h"
#include "input/vertex_values.h"
#include "ranks/first_rank.h"
#include "ranks/piece_rows.h"

namespace brindle::tool {
namespace {

constexpr const char* kBy = "--frequency-by";

/// Values that frequencies follow: an array, or a number per vertex of the partition.
DataArray frequency_values(Communicator& ranks, const DistributedSurface& surface,
                           const ReadPiece& read, const ArrayOptions& options,
                           const PieceArrays& arrays) {
  const std::string& value = options.frequency_by;
  if (is_array(value)) return arrays.array(parse_array(kBy, value)).array;
  if (const std::string file = value_file(value); !file.empty()) {
    return piece_rows(ranks, read, kBy, file, [&] {
      const VertexValues values =
          csv_values(kBy, value, surface.own_vertex_count(), read.vertex_of_row);
      return std::vector<DataArray>{make_data_array(values.title, 1, values.values)};
    })[0];
  }
  if (value == "curvature") {
    return make_data_array(value, 1, greatest_curvatures(surface));
  }
  VertexValues values;
  ranks.throw_on_all([&] {
    const Surface piece{{read.piece.mesh.positions, {}, read.piece.mesh.origin}, nullptr, {}};
    values = vertex_values(kBy, value, {piece, {}, read.file, options, {}});
  });
  return make_data_array(values.title, 1, values.values);
}

FrequencyField frequencies_by_values(Communicator& ranks, const DistributedSurface& surface,
                                     const DataArray& values, float frequency,
                                     const FrequencyRange& range) {
  NumberExtent extent;
  ranks.throw_on_all([&] { extent = extent_of(values, used_own(surface)); });
  for (const NumberExtent& other : ranks.all(extent)) {
    extent.lowest = std::min(extent.lowest, other.lowest);
    extent.highest = std::max(extent.highest, other.highest);
  }
  FrequencyField frequencies;
  ranks.throw_on_all([&] { frequencies = frequencies_by(values, extent, frequency, range); });
  return frequencies;
}

FrequencyField chosen_frequencies(Communicator& ranks, const DistributedSurface& surface,
                                  const ReadPiece& read, const WaveOptions& options,
                                  const PieceField& field) {
  const ArrayOptions& wanted = options.arrays;
  const float frequency = constant_frequency(static_cast<float>(surface.diagonal()), options);
  if (!wanted.frequency.empty()) {
    const DataArray array = field.arrays->array(wanted.frequency).array;
    FrequencyField frequencies;
    ranks.throw_on_all([&] { frequencies = frequencies_of(array, field.directions); });
    return frequencies;
  }
  if (!wanted.frequency_by.empty()) {
    return frequencies_by_values(ranks, surface,
                                 frequency_values(ranks, surface, read, wanted, *field.arrays),
                                 frequency, wanted.range);
  }
  if (!field.frequencies.empty() && !says_one_frequency(options)) return field.frequencies;
  FrequencyField constant = constant_frequency_field(frequency, field.directions.size());
  keep_gaps(field.frequencies, constant);
  return constant;
}

}  // namespace

void choose_piece_frequencies(Communicator& ranks, const DistributedSurface& surface,
                              const ReadPiece& read, const WaveOptions& options,
                              PieceField& field) {
  const bool field_says = ranks.any(!field.frequencies.empty());
  field.frequencies = chosen_frequencies(ranks, surface, read, options, field);
  if (options.detail.frequency_periods == 0) return;
  if (!says_frequencies(options) && !field_says) refuse_frequency_smoothing();
}

}  // namespace brindle::tool
