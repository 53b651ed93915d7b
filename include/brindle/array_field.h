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

/// The number of rows with a non-finite number.
std::size_t nonfinite_rows(const DataArray& array);

/// Projects vectors of any length (`tangent_directions`), with three components or two in the
/// xy-plane. Rows blended from several are their means as axes or, with `signs`, as vectors, of
/// which opposite ones cancel. Throws Error, naming the array, for other numbers of components or
/// rows.
DirectionField direction_field_of(const Surface& surface, const DataArray& vectors,
                                  bool signs = false);

/// Factors of a frequency for the smallest and the largest number of an array.
struct FrequencyRange {
  float lowest = 0.4f;   ///< above zero
  float highest = 2.5f;  ///< above `lowest`
  bool inverse = false;  ///< `highest` for the smallest number, `lowest` for the largest
  /// The factor is 1 over the number, clamped to `lowest` and `highest`.
  bool reciprocal = false;
};

/// Frequencies in stripes per unit length, one per vertex; NaN where the array is not finite.
/// Numbers, or magnitudes of vectors, map linearly to multiples of `frequency`. The smallest and
/// the largest at vertices with neighbours map to the ends of `range`. Equal numbers map to the
/// geometric mean of the ends, which is 1 for 0.4 and 2.5. In a reciprocal range, numbers of 0 or
/// below map to `highest`. Throws Error for ranges and frequencies that are not above zero and
/// finite. Throws Error, naming the array, without a finite number at these vertices, and for
/// another number of rows than vertices.
FrequencyField frequencies_by(const Surface& surface, const DataArray& array, float frequency,
                              const FrequencyRange& range = {});

/// Numbers of the array, or magnitudes of its vectors, as stripes per unit length; NaN where they
/// are NaN. Throws Error, naming the array and the vertex, if the number at a vertex with a wave
/// (`directions`) is not finite and above zero as a float; and for another number of rows than
/// vertices.
FrequencyField frequencies_of(const DataArray& array, std::span<const Vec3> directions);

/// Removes the wave of every vertex without a frequency (NaN), and sets its frequency to the mean
/// of all others, so that all are finite. Returns the number of waves removed.
std::size_t drop_waves_without_frequency(DirectionField& directions, FrequencyField& frequencies);

}  // namespace brindle
