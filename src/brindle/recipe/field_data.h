/// What a measured field was made of, and how much every datum counts.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/frequency_field.h"
#include "brindle/measured_field.h"
#include "brindle/mesh.h"

namespace brindle {

/// A field as it was read.
struct FieldData {
  DataArray array;            ///< vectors or tensors; no rows if the field is neither
  bool of_triangles = false;  ///< a row per triangle, not per vertex
};

/// What --field-weight says.
struct FieldWeight {
  std::string word;  ///< "length" or "anisotropy", of the data themselves; or empty
  std::vector<float>
      values;  ///< otherwise one per vertex, or per triangle where the data are; not
               ///< finite: no datum. Empty: tensors by their anisotropy, others alike
};

/// The data of a field with their weights; `directions` are those at vertices. Throws RefusedOption
/// for weights below zero, and for words that the data have no such thing for.
MeasuredField measured_field(const FieldData& data, const DirectionField& directions,
                             const FieldWeight& weight);

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

/// Numbers of triangles: those of their corners on average.
std::vector<float> corner_means(const Mesh& mesh, const std::vector<float>& of_vertices);

}  // namespace brindle
