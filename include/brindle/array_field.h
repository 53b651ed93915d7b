/// Waves from arrays: directions from vectors (of tensors: tensor_field.h), frequencies from
/// numbers. Arrays have a row per vertex; `cells_to_points` (mesh_data.h) makes such of rows per
/// triangle.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/frequency_field.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// Rows with a number that is not finite.
std::size_t nonfinite_rows(const DataArray& array);

/// Directions of vectors of three numbers, or of two in the plane of x and y, of any length: what
/// `tangent_directions` gives. Throws Error, naming the array, for other numbers of components, and
/// unless there is a row per vertex.
DirectionField direction_field_of(const Surface& surface, const DataArray& vectors);

/// Factors of a frequency for the smallest and the largest number of an array.
struct FrequencyRange {
  float lowest = 0.4f;   ///< above zero
  float highest = 2.5f;  ///< above `lowest`
  bool inverse = false;  ///< the other way round: `highest` for the smallest number
  /// Instead of both: one over the number, held between `lowest` and `highest`.
  bool reciprocal = false;
};

/// Frequencies, NaN where the array is not finite. The array's numbers, or the lengths of its
/// vectors, are mapped linearly to multiples of `frequency`: the smallest and the largest at any
/// vertex with neighbours to the ends of `range`. If all are the same, the factor is the ends'
/// geometric mean, which is 1 for 0.4 and 2.5. A reciprocal range says all by itself: numbers that
/// are not above zero have the factor `highest`. Throws Error, naming the array, for ranges and
/// frequencies that are not above zero and finite, for an array without a finite number, and unless
/// there is a row per vertex.
FrequencyField frequencies_by(const Surface& surface, const DataArray& array, float frequency,
                              const FrequencyRange& range = {});

/// The array's numbers, or the lengths of its vectors, as stripes per unit length; NaN where they
/// are NaN. Throws Error, naming the array and the vertex, where there is a wave (`directions`) and
/// the number is not above zero and finite as a float, and unless there is a row per vertex.
FrequencyField frequencies_of(const DataArray& array, std::span<const Vec3> directions);

/// Takes the wave from every vertex without a frequency (NaN), and gives it the mean of all others,
/// so that all frequencies are finite. Returns how many waves were taken.
std::size_t drop_waves_without_frequency(DirectionField& directions, FrequencyField& frequencies);

}  // namespace brindle
