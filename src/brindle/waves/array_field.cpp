#include "brindle/array_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "brindle/base/array_numbers.h"
#include "brindle/base/array_rows.h"
#include "brindle/base/axis_mean.h"
#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/waves/frequency_parts.h"

namespace brindle {
namespace {

/// One number per row; for vectors their length, also if it is extreme.
std::vector<double> lengths_of_rows(const DataArray& array) {
  std::vector<double> numbers = doubles_of(array.axes());
  if (array.components == 1) return numbers;
  const Eigen::Map<const Eigen::MatrixXd> rows(numbers.data(), array.components,
                                               static_cast<Eigen::Index>(array.rows()));
  std::vector<double> lengths(array.rows());
  for (Eigen::Index row = 0; row < rows.cols(); ++row) {
    lengths[static_cast<std::size_t>(row)] = rows.col(row).stableNorm();
  }
  return lengths;
}

/// The position of a number in the range, from 0 to 1. Halved, because the difference of two
/// doubles may overflow.
double share_of(const NumberExtent& extent, double number) {
  return (number / 2 - extent.lowest / 2) / (extent.highest / 2 - extent.lowest / 2);
}

bool is_positive(double number) { return number > 0 && std::isfinite(number); }

void check_range(float frequency, const FrequencyRange& range) {
  if (is_positive(frequency) && is_positive(range.lowest) && is_positive(range.highest) &&
      range.lowest < range.highest) {
    return;
  }
  throw Error(
      "frequencies by an array need a frequency and two factors above zero, the first "
      "factor below the second; not " +
      std::to_string(frequency) + ", " + std::to_string(range.lowest) + " and " +
      std::to_string(range.highest));
}

double reciprocal_factor(const FrequencyRange& range, double number) {
  const double lowest = range.lowest, highest = range.highest;
  return number * highest > 1 ? std::max(1 / number, lowest) : highest;
}

}  // namespace

std::size_t nonfinite_rows(const DataArray& array) {
  std::size_t count = 0;
  bool counted = false;
  for_each_number(array.view(), [&](std::size_t, std::size_t column, auto number) {
    if (column == 0) counted = false;
    if (counted || std::isfinite(static_cast<double>(number))) return;
    counted = true;
    ++count;
  });
  return count;
}

DirectionField direction_field_of(const Surface& surface, const DataArray& vectors, bool signs) {
  check_rows_per_vertex(vectors, surface.mesh.vertex_count());
  const auto columns = static_cast<std::size_t>(vectors.components);
  if (columns != 2 && columns != 3) {
    throw Error("array '" + vectors.name + "' has " + std::to_string(columns) +
                " numbers in a row; a direction needs 3 (a vector), or 2 (one in the plane of x "
                "and y)");
  }
  const std::vector<double> numbers = doubles_of(signs ? vectors.view() : vectors.axes());
  DirectionField directions(vectors.rows());
  parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const double* row = &numbers[v * columns];
      directions[v] = tangent_direction(float_vector({row[0], row[1], columns == 3 ? row[2] : 0}),
                                        surface.normals[v]);
    }
  });
  return directions;
}

NumberExtent extent_of(const DataArray& array, std::span<const std::uint8_t> counted) {
  check_rows_per_vertex(array, counted.size());
  const std::vector<double> numbers = lengths_of_rows(array);
  NumberExtent extent;
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (!std::isfinite(numbers[v]) || counted[v] == 0) continue;
    extent.lowest = std::min(extent.lowest, numbers[v]);
    extent.highest = std::max(extent.highest, numbers[v]);
  }
  return extent;
}

FrequencyField frequencies_by(const Surface& surface, const DataArray& array, float frequency,
                              const FrequencyRange& range) {
  std::vector<std::uint8_t> used(surface.mesh.vertex_count());
  for (Index v = 0; v < used.size(); ++v) used[v] = surface.neighborhood->of(v).empty() ? 0 : 1;
  return frequencies_by(array, extent_of(array, used), frequency, range);
}

FrequencyField frequencies_by(const DataArray& array, const NumberExtent& extent, float frequency,
                              const FrequencyRange& range) {
  check_range(frequency, range);
  const std::vector<double> numbers = lengths_of_rows(array);
  if (extent.lowest > extent.highest) {
    throw Error("array '" + array.name + "' has no finite number, and gives no frequencies");
  }
  const double low = range.inverse ? range.highest : range.lowest;
  const double high = range.inverse ? range.lowest : range.highest;
  FrequencyField frequencies(numbers.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (!std::isfinite(numbers[v])) continue;
    if (range.reciprocal) {
      frequencies[v] = static_cast<float>(frequency * reciprocal_factor(range, numbers[v]));
      continue;
    }
    // Vertices without neighbours, which have no wave, may be out of range.
    const double share = std::clamp(share_of(extent, numbers[v]), 0.0, 1.0);
    const double factor =
        extent.lowest == extent.highest ? std::sqrt(low * high) : std::lerp(low, high, share);
    frequencies[v] = static_cast<float>(frequency * factor);
  }
  return frequencies;
}

FrequencyField frequencies_of(const DataArray& array, std::span<const Vec3> directions) {
  check_rows_per_vertex(array, directions.size());
  const std::vector<double> numbers = lengths_of_rows(array);
  FrequencyField frequencies(numbers.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    const auto frequency = static_cast<float>(numbers[v]);
    if (is_positive(frequency)) {
      frequencies[v] = frequency;
    } else if (!std::isnan(numbers[v]) && !directions[v].isZero(0)) {
      throw Error("array '" + array.name + "': the frequency of vertex " + std::to_string(v) +
                  formatted(" is %g", numbers[v]) +
                  "; where there is a wave it must be a number from 1.2e-38 to 3.4e38, or NaN for "
                  "none");
    }
  }
  return frequencies;
}

FrequencySum sum_of(std::span<const float> frequencies, std::span<const std::uint8_t> counted) {
  FrequencySum sum;
  for (std::size_t v = 0; v < frequencies.size(); ++v) {
    if (std::isnan(frequencies[v]) || counted[v] == 0) continue;
    sum.sum += frequencies[v];
    ++sum.count;
  }
  return sum;
}

std::size_t drop_waves_without_frequency(DirectionField& directions, FrequencyField& frequencies) {
  const std::vector<std::uint8_t> all(frequencies.size(), 1);
  return drop_waves_without_frequency(directions, frequencies, sum_of(frequencies, all).mean());
}

std::size_t drop_waves_without_frequency(DirectionField& directions, FrequencyField& frequencies,
                                         float mean) {
  std::size_t dropped = 0;
  for (std::size_t v = 0; v < frequencies.size(); ++v) {
    if (!std::isnan(frequencies[v])) continue;
    dropped += directions[v].isZero(0) ? 0 : 1;
    directions[v] = Vec3::Zero();
    frequencies[v] = mean;
  }
  return dropped;
}

}  // namespace brindle
