/// Directions on a globe, and gaps of fields.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/frequency_field.h"
#include "brindle/measured_field.h"
#include "brindle/mesh.h"
#include "brindle/waves_of.h"

namespace brindle {

/// Whether there is any direction.
bool has_data(const MeasuredField& measured);

/// Converts vectors on a globe around the origin with axis z: rows of two numbers per vertex,
/// towards east and north, become x, y and z. NaN at the poles, where no direction is north. Throws
/// Error for other rows, and for meshes that are no part of such a globe: distances from the origin
/// must be within a factor of 2.
DataArray globe_vectors(const Mesh& mesh, const DataArray& east_north);

/// Distances of vertices from the origin.
struct GlobeRadii {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
};
GlobeRadii globe_radii(const Mesh& mesh);

/// The same for a part of a mesh, with the distances of the whole.
DataArray globe_vectors(const Mesh& part, const DataArray& east_north, const GlobeRadii& of_whole);

/// Copies the gaps of `of_file` into `frequencies`: a field without a frequency in its file has no
/// wave there, whichever frequencies are used elsewhere. `of_file` may be empty.
void keep_gaps(const FrequencyField& of_file, FrequencyField& frequencies);

// Selects arrays by the names that users give.

/// "velocity (3), speed".
std::string list_of(std::span<const DataArray> arrays);

struct ArrayChoice {
  const DataArray* array = nullptr;  ///< one of the given arrays
  bool of_cells = false;
};

/// The array NAME, points/NAME or cells/NAME. Throws Error for another name, with `file` and all
/// available arrays.
ArrayChoice choice_of(const DataArrays& arrays, const std::string& name, const std::string& file);

/// The same, copied.
DataArray array_named(const DataArrays& arrays, const std::string& name, const std::string& file);

/// The arrays of several names, each once.
DataArrays named_arrays(const DataArrays& arrays, std::span<const std::string> names,
                        const std::string& file);

}  // namespace brindle
