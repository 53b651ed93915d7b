/// Direction fields along the eigenvectors of symmetric tensors, such as stresses.
#pragma once

#include <cstddef>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// Whether rows are symmetric tensors: 6 or 9 numbers.
bool is_tensor(const DataArray& array);

/// An eigenvector of a symmetric tensor.
enum class TensorAxis {
  major,    ///< of the largest eigenvalue
  minor,    ///< of the smallest one
  max_abs,  ///< of the eigenvalue of largest absolute value; of two of the same size, the positive
            ///< one
  // Of the tensor's part within the tangent plane: at a free surface, the stress there.
  tangent_major,  ///< of the larger of its two eigenvalues
  tangent_minor   ///< of the smaller one
};

/// The order of a tensor's components in a row.
enum class TensorOrder {
  vtk,    ///< XX, YY, ZZ, XY, YZ, XZ, or all 9 row by row
  voigt,  ///< XX, YY, ZZ, YZ, XZ, XY
  plane   ///< of x and y: XX, YY, XY, or all 4 row by row; the other components are 0
};

/// The array in VTK's order, in doubles; as it is, if it is so already. Throws Error, naming it,
/// for a number of components that the order does not have.
DataArray in_vtk_order(const DataArray& tensors, TensorOrder order);

/// Directions along eigenvectors, and numbers of vertices for warnings.
struct TensorField {
  DirectionField directions;      ///< one per vertex; neighbours run alike (`orient_alike`)
  std::size_t near_normal = 0;    ///< without a wave: the axis is too near to the normal
  std::size_t isotropic = 0;      ///< without a wave: several axes share the eigenvalue
  std::size_t not_symmetric = 0;  ///< asymmetric by more than a millionth of the largest number
};

/// One eigenvector per vertex, projected into the tangent plane. Rows have 6 numbers in VTK's
/// order, XX, YY, ZZ, XY, YZ, XZ, or 9: a matrix row by row, whose symmetric part is used. A vertex
/// has no wave if a number is not finite, if the eigenvector is within 15 degrees of the normal, or
/// if another eigenvalue is equal up to a millionth of the largest absolute one (for tangent axes,
/// of the tangential part). Throws Error, naming the array, for other numbers of components or
/// rows.
TensorField tensor_field_of(const Surface& surface, const DataArray& tensors, TensorAxis axis);

/// The fractional anisotropy of every tensor (Basser and Pierpaoli 1996): 0 if all eigenvalues are
/// equal, 1 if all but one are 0, NaN if a number is not finite. Throws Error, naming the array,
/// for other numbers of components.
std::vector<float> tensor_anisotropy(const DataArray& tensors);

}  // namespace brindle
