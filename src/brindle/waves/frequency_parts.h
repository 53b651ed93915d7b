/// Frequencies of a surface in parts: what a vertex's frequency depends on beside its own number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "brindle/array_field.h"

namespace brindle {

/// Over the parts of a surface the least of `lowest` and the greatest of `highest`.
struct NumberExtent {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
};

/// Of the finite numbers of an array, or the lengths of its vectors, in the rows that are
/// `counted`.
NumberExtent extent_of(const DataArray& array, std::span<const std::uint8_t> counted);

/// As `frequencies_by` of array_field.h, with the extent of the whole surface's numbers.
FrequencyField frequencies_by(const DataArray& array, const NumberExtent& extent, float frequency,
                              const FrequencyRange& range);

/// What parts of a surface add up for the mean frequency.
struct FrequencySum {
  double sum = 0;
  std::size_t count = 0;

  float mean() const {
    return count == 0 ? 1.0f : static_cast<float>(sum / static_cast<double>(count));
  }
};

/// Of those that are `counted` and no NaN.
FrequencySum sum_of(std::span<const float> frequencies, std::span<const std::uint8_t> counted);

/// As `drop_waves_without_frequency` of array_field.h, with the mean of the whole surface.
std::size_t drop_waves_without_frequency(DirectionField& directions, FrequencyField& frequencies,
                                         float mean);

}  // namespace brindle
