/// Waves from arrays: directions from vectors (tensor_field.h: from tensors), frequencies from
/// numbers. Arrays have one row per vertex; `cells_to_points` (mesh_data.h) converts rows per
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

/// The number of rows with a number that is not finite.
std::size_t nonfinite_rows(const DataArray& array);

/// `tangent_directions` of vectors of any length, with three components, or two in the plane of x
/// and y. Where rows are means of others, these were axes, or, with `signs`, vectors, of which
/// opposite ones cancel each other. Throws Error, naming the array, for other numbers of components
/// or rows.
DirectionField direction_field_of(const Surface& surface, const DataArray& vectors,
                                  bool signs = false);

/// The factors of a frequency for the smallest and the largest number of an array.
struct FrequencyRange {
  float lowest = 0.4f;   ///< above zero
  float highest = 2.5f;  ///< above `lowest`
  bool inverse = false;  ///< `highest` for the smallest number, `lowest` for the largest
  /// The factor is one over the number instead, clamped to `lowest` and `highest`.
  bool reciprocal = false;
};

/// Frequencies in stripes per unit length, one per vertex; NaN where the array is not finite. The
/// array's numbers, or the lengths of its vectors, are mapped linearly to multiples of `frequency`:
/// the smallest and the largest at vertices with neighbours to the ends of `range`. If all are
/// equal, the factor is the geometric mean of the ends, which is 1 for 0.4 and 2.5. In a reciprocal
/// range numbers of 0 or below have the factor `highest`. Throws Error, naming the array, for
/// ranges and frequencies that are not above zero and finite, for an array without a finite number,
/// and for another number of rows than vertices.
FrequencyField frequencies_by(const Surface& surface, const DataArray& array, float frequency,
                              const FrequencyRange& range = {});

/// The array's numbers, or the lengths of its vectors, as stripes per unit length; NaN where they
/// are NaN. Throws Error, naming the array and the vertex, for a number that is not above zero and
/// finite as a float at a vertex with a wave (`directions`), and for another number of rows than
/// vertices.
FrequencyField frequencies_of(const DataArray& array, std::span<const Vec3> directions);

/// Removes the wave of every vertex without a frequency (NaN), and sets its frequency to the mean
/// of all others, so that all are finite. Returns the number of waves removed.
std::size_t drop_waves_without_frequency(DirectionField& directions, FrequencyField& frequencies);

}  // namespace brindle
