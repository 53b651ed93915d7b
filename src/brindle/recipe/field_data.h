/// Directions on a globe, and gaps of fields.
#pragma once

#include <limits>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/frequency_field.h"
#include "brindle/measured_field.h"
#include "brindle/mesh.h"
#include "brindle/waves_of.h"

namespace brindle {

/// Whether there is a direction at all.
bool has_data(const MeasuredField& measured);

/// Vectors on a globe around the origin whose axis is z: rows of two numbers, towards the east and
/// the north, one per vertex, become x, y and z. Not a number at the poles, where no direction is
/// north. Throws Error for other rows, and for a mesh that is no part of such a globe: the
/// distances of its vertices from the origin must be within a factor of 2.
DataArray globe_vectors(const Mesh& mesh, const DataArray& east_north);

/// Distances of vertices from the origin.
struct GlobeRadii {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
};
GlobeRadii globe_radii(const Mesh& mesh);

/// The same for a part of a mesh, with the distances of the whole.
DataArray globe_vectors(const Mesh& part, const DataArray& east_north, const GlobeRadii& of_whole);

/// Copies the gaps of `of_file` into `frequencies`: where a field's file has no frequency there is
/// no wave, whichever frequencies are used elsewhere. `of_file` may be empty.
void keep_gaps(const FrequencyField& of_file, FrequencyField& frequencies);

}  // namespace brindle
