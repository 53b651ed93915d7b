#include "wave_settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <brindle/distributed_waves.h>
#include <brindle/error.h>
#include <brindle/frequency_field.h>
#include <brindle/measured_field.h>
#include <brindle/smooth_field.h>
#include <brindle/types.h>

#include "vtk_arrays.h"

namespace brindle::paraview {
namespace {

constexpr float kCurvatureAnchor = 0.1f;  // as in `brindle stripe --field curvature`

DirectionField array_directions(const Surface& surface, const WaveSettings& settings,
                                const DataArray* vectors) {
  if (vectors == nullptr) throw Error("choose an array of vectors for the field");
  if (!is_tensor(*vectors)) return direction_field_of(surface, *vectors);
  return tensor_field_of(surface, *vectors, settings.tensor_axis).directions;
}

/// Numbers, or magnitudes of vectors.
std::vector<float> lengths_of(const DataArray& array) {
  const std::vector<double> numbers = doubles_of(array);
  const auto columns = static_cast<std::size_t>(array.components);
  std::vector<float> lengths;
  for (std::size_t row = 0; row < array.rows(); ++row) {
    const double* first = &numbers[columns * row];
    double length = columns == 1 ? *first : 0;
    for (std::size_t c = 0; columns > 1 && c < columns; ++c) length = std::hypot(length, first[c]);
    lengths.push_back(static_cast<float>(length));
  }
  return lengths;
}

/// Values of the whole surface that a partition lacks.
struct Whole {
  float diagonal = 0;
  std::optional<std::array<double, 2>> extent;  ///< of the numbers of frequencies
};

/// The smallest and largest number, or magnitude, of own vertices with neighbours; the first is
/// above the second if there are none.
std::array<double, 2> own_extent(const Surface& surface, const DataArray& array,
                                 const RankPiece& piece) {
  const std::span<const std::uint8_t> is_own = piece.surface().is_own();
  std::vector<Index> rows;
  for (Index v = 0; v < is_own.size(); ++v) {
    if (is_own[v] != 0 && !surface.neighborhood->of(v).empty()) rows.push_back(v);
  }
  const DataArray counted = rows_of(array, rows);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (nonfinite_rows(counted) == counted.rows()) return {kNone, -kNone};
  const ArrayMetrics metrics = measure_array(counted);
  return {metrics.minimum, metrics.maximum};
}

Whole whole_of(const Surface& surface, const WaveSettings& settings, const DataArray* frequencies,
               const RankPiece* piece) {
  if (piece == nullptr) return {bounding_box(surface.mesh).diagonal(), std::nullopt};
  Whole whole{static_cast<float>(piece->surface().diagonal()), std::nullopt};
  // Settings, and the existence of an array, are the same on all ranks.
  if (settings.frequency_source != FrequencySource::by_array || frequencies == nullptr)
    return whole;
  std::array<double, 2> extent{};
  piece->ranks().throw_on_all([&] { extent = own_extent(surface, *frequencies, *piece); });
  whole.extent = piece->extent(extent);
  return whole;
}

/// As `frequencies_by` for the extent of the whole, by two additional neighbouring vertices with
/// the smallest and the largest number.
FrequencyField frequencies_within(const DataArray& array, std::array<double, 2> extent,
                                  float frequency, const FrequencyRange& range) {
  std::vector<double> numbers = doubles_of(array);
  for (const double end : extent) {
    numbers.push_back(end);
    numbers.resize(numbers.size() + static_cast<std::size_t>(array.components) - 1);
  }
  const DataArray more = make_data_array(array.name, array.components, numbers);
  Adjacency pair;
  const auto count = static_cast<Index>(more.rows());
  pair.offsets.assign(count + 1, 0);
  pair.offsets[count - 1] = 1;
  pair.offsets[count] = 2;
  pair.neighbors = {count - 1, count - 2};
  Surface surface;
  surface.mesh.positions.assign(count, Vec3::Zero());
  surface.neighborhood = std::make_shared<const Adjacency>(std::move(pair));
  FrequencyField frequencies = frequencies_by(surface, more, frequency, range);
  frequencies.resize(count - 2);
  return frequencies;
}

FrequencyField make_frequencies(const Surface& surface, const WaveSettings& settings,
                                const Whole& whole, const DirectionField& directions,
                                const DataArray* frequencies) {
  const auto along_diagonal = [&] {
    return frequency_of_stripes(settings.stripes, whole.diagonal);
  };
  if (settings.needs_frequency_array() && frequencies == nullptr) {
    throw Error("choose an array for the frequency");
  }
  switch (settings.frequency_source) {
    case FrequencySource::array:
      return frequencies_of(*frequencies, directions);
    case FrequencySource::by_array:
      if (whole.extent) {
        return frequencies_within(*frequencies, *whole.extent, along_diagonal(), settings.range);
      }
      return frequencies_by(surface, *frequencies, along_diagonal(), settings.range);
    case FrequencySource::per_length:
      return constant_frequency_field(settings.frequency, surface.mesh.vertex_count());
    case FrequencySource::spacing:
      return constant_frequency_field(frequency_of_spacing(settings.spacing),
                                      surface.mesh.vertex_count());
    case FrequencySource::along_diagonal:
      break;
  }
  return constant_frequency_field(along_diagonal(), surface.mesh.vertex_count());
}

/// The data of the field: cell data unchanged, as lines or arrows of triangles.
MeasuredField measured_data(const Surface& surface, const WaveArrays& arrays,
                            const DirectionField& directions) {
  const bool of_triangles = arrays.cell_vectors != nullptr && !is_tensor(*arrays.vectors);
  const FieldData data{of_triangles ? *arrays.cell_vectors : *arrays.vectors, of_triangles};
  FieldWeight weight;
  if (arrays.weights != nullptr && of_triangles && arrays.cell_weights != nullptr) {
    weight.values = lengths_of(*arrays.cell_weights);
  } else if (arrays.weights != nullptr) {
    weight.values = lengths_of(*arrays.weights);
    if (of_triangles) weight.values = corner_means(surface.mesh, weight.values);
  }
  const auto is_below_zero = [](float value) { return value < 0; };
  if (std::ranges::any_of(weight.values, is_below_zero)) {
    throw Error("Field Weight: there are weights below zero");
  }
  return measured_field(data, directions, weight);
}

FieldSmoothingOptions smoothing_options(const WaveSettings& settings) {
  FieldSmoothingOptions options;
  options.periods = settings.smoothing;
  options.fill = settings.fill;
  options.symmetry = settings.arrows ? 1 : 2;
  options.memory = settings.memory;
  if (settings.singularities >= 0) {
    options.singularities = static_cast<std::size_t>(settings.singularities);
  }
  return options;
}

WaveRequest request_of(const WaveSettings& settings) {
  WaveRequest request;
  request.turn_deg = settings.turn_deg;
  if (settings.field == FieldSource::array) request.smoothing = smoothing_options(settings);
  if (settings.needs_frequency_array()) {
    request.frequency_smoothing.periods = settings.frequency_smoothing;
    request.frequency_smoothing.fill = settings.fill;
  }
  return request;
}

/// Waves before smoothing; `directions` are those of computed fields.
WaveInput found_waves(const Surface& surface, const WaveSettings& settings, const Whole& whole,
                      DirectionField directions, const WaveArrays& arrays) {
  if (settings.field == FieldSource::direction) {
    directions = projected_direction_field(settings.direction, surface.normals);
  } else if (settings.field == FieldSource::array) {
    directions = array_directions(surface, settings, arrays.vectors);
  }
  WaveInput found{std::move(directions), {}};
  found.frequencies =
      make_frequencies(surface, settings, whole, found.directions, arrays.frequencies);
  found.may_have_gaps = settings.needs_frequency_array();
  if (settings.smoothing > 0 && settings.field == FieldSource::array) {
    found.measured = measured_data(surface, arrays, found.directions);
  }
  return found;
}

}  // namespace

DirectionField made_directions(const Surface& surface, const WaveSettings& settings,
                               const RankPiece* piece, DirectionField last) {
  SmoothFieldOptions options;
  options.last.directions = std::move(last);
  if (settings.field == FieldSource::curvature) options.curvature_anchor = kCurvatureAnchor;
  options.curvature_direction = settings.curvature_direction;
  if (piece != nullptr) return smooth_direction_field(piece->surface(), options);
  return smooth_direction_field(surface, options);
}

WaveResult make_waves(const Surface& surface, const WaveSettings& settings, DirectionField made,
                      const WaveArrays& arrays, const DirectionField& last,
                      const RankPiece* piece) {
  const Whole whole = whole_of(surface, settings, arrays.frequencies, piece);
  WaveInput found;
  const auto find = [&] {
    found = found_waves(surface, settings, whole, std::move(made), arrays);
    found.last = last;
  };
  if (piece == nullptr) {
    find();
    return waves_of(WholeSurface(surface), request_of(settings), std::move(found));
  }
  piece->ranks().throw_on_all(find);
  WaveResult result = waves_of(PieceSurface(piece->surface(), surface.mesh), request_of(settings),
                               std::move(found));
  piece->owners().from_owners(std::span(result.waves.directions));
  piece->owners().from_owners(std::span(result.waves.frequencies));
  return result;
}

}  // namespace brindle::paraview
