/// Arrays from VTK's data to the library and back.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <brindle/arrays.h>
#include <brindle/data_arrays.h>
#include <brindle/types.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkDataArray;
class vtkDataSetAttributes;

namespace brindle::paraview {

/// A copy, row by row, in the type that it has. Throws Error, naming the array, for types that are
/// no numbers of a whole number of bytes.
DataArray data_array_of(vtkDataArray& array);

/// The same array in VTK's form.
vtkSmartPointer<vtkDataArray> vtk_array(const DataArray& array);

/// Its numbers, row by row.
std::vector<double> doubles_of(const DataArray& array);

/// Copies all arrays of `from`, text as well, with a row per blend: means of floating-point
/// numbers, of others the row with the largest weight, of equal ones the first (as `blended`).
/// What `to` has by the same name stays, and arrays that are too short are left out. Scalars,
/// vectors, normals and tensors that were active are so in `to`, unless it has some.
void carry(vtkDataSetAttributes& from, std::span<const RowBlend> blends, vtkDataSetAttributes& to);

/// A blend of one row.
inline RowBlend whole_row(Index row) { return {{row, row, row}, {1, 0, 0}}; }

}  // namespace brindle::paraview
