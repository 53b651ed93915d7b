/// Frequencies of a surface in parts: the sums that the frequency of a vertex depends on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "brindle/array_field.h"

namespace brindle {

/// The range of an array's numbers; that of a surface in parts is the union of its parts' ranges.
struct NumberExtent {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
};

/// The range of the finite numbers of an array, or the lengths of its vectors, in rows that are
/// `counted` (1).
NumberExtent extent_of(const DataArray& array, std::span<const std::uint8_t> counted);

/// As `frequencies_by` of array_field.h, for the range of the whole surface.
FrequencyField frequencies_by(const DataArray& array, const NumberExtent& extent, float frequency,
                              const FrequencyRange& range);

/// The sum from which the mean frequency follows; parts of a surface add theirs.
struct FrequencySum {
  double sum = 0;
  std::size_t count = 0;

  float mean() const {
    return count == 0 ? 1.0f : static_cast<float>(sum / static_cast<double>(count));
  }
};

/// Sums the frequencies that are `counted` (1) and not NaN.
FrequencySum sum_of(std::span<const float> frequencies, std::span<const std::uint8_t> counted);

/// As `drop_waves_without_frequency` of array_field.h, for the mean of the whole surface.
std::size_t drop_waves_without_frequency(DirectionField& directions, FrequencyField& frequencies,
                                         float mean);

}  // namespace brindle
