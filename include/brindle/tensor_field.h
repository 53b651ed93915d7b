/// Direction fields along the eigenvectors of symmetric tensors, such as stresses.
#pragma once

#include <cstddef>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// Whether rows have as many numbers as a symmetric tensor: 6 or 9.
bool is_tensor(const DataArray& array);

/// Which eigenvector of a symmetric tensor.
enum class TensorAxis {
  major,   ///< of the largest eigenvalue
  minor,   ///< of the smallest one
  max_abs  ///< of the one with the largest absolute value; of two of the same size, the positive
};

struct TensorField {
  DirectionField directions;    ///< signs are such that neighbours run alike
  std::size_t near_normal = 0;  ///< vertices without a wave: the axis is too near to the normal
  std::size_t isotropic = 0;    ///< vertices without a wave: more than one axis has the eigenvalue
  std::size_t not_symmetric = 0;  ///< vertices, by more than a millionth of their largest number
};

/// One eigenvector per vertex, projected into the tangent plane. Rows are 6 numbers in VTK's order,
/// XX, YY, ZZ, XY, YZ, XZ, or 9, a matrix row by row, whose symmetric part counts. There is no wave
/// where a number is not finite, where the eigenvector is within 15 degrees of the normal, and
/// where another eigenvalue is the same but for a millionth of the largest absolute one. Throws
/// Error, naming the array, for other numbers of components, and unless there is a row per vertex.
TensorField tensor_field_of(const Surface& surface, const DataArray& tensors, TensorAxis axis);

/// The fractional anisotropy of every tensor (Basser and Pierpaoli 1996): 0 where all eigenvalues
/// are the same, 1 where all but one are 0; NaN where a number is not finite. Throws Error, naming
/// the array, for other numbers of components.
std::vector<float> tensor_anisotropy(const DataArray& tensors);

}  // namespace brindle
