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
/// north. Throws Error for other rows, and for a mesh that is no part of such a globe: whose
/// vertices are not all about as far from the origin, to a factor of 2.
DataArray globe_vectors(const Mesh& mesh, const DataArray& east_north);

/// How far vertices are from the origin.
struct GlobeRadii {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
};
GlobeRadii globe_radii(const Mesh& mesh);

/// The same of a part of a mesh whose vertices are so far from the origin.
DataArray globe_vectors(const Mesh& part, const DataArray& east_north, const GlobeRadii& of_whole);

/// Gives `frequencies` the gaps of others: where a field's file has no frequency it has no wave,
/// whatever the frequency of the others is. `of_file` may be empty.
void keep_gaps(const FrequencyField& of_file, FrequencyField& frequencies);

}  // namespace brindle
