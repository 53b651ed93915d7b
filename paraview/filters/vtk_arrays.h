/// Converts arrays between VTK and the library.
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

/// A copy in the array's type. Throws Error with the array's name for types other than numbers of
/// whole bytes.
DataArray data_array_of(vtkDataArray& array);

/// The array in VTK's form.
vtkSmartPointer<vtkDataArray> vtk_array(const DataArray& array);

/// Its numbers, row by row.
std::vector<double> doubles_of(const DataArray& array);

/// Copies all arrays of `from`, including text, with a row per blend: means of floating-point
/// numbers; for others the row with the largest weight, the first one if equal (as `blended`).
/// Keeps arrays of `to` with the same name, and skips arrays that are too short. Active scalars,
/// vectors, normals and tensors stay active in `to`, unless it has its own.
void carry(vtkDataSetAttributes& from, std::span<const RowBlend> blends, vtkDataSetAttributes& to);

/// A blend of one row.
inline RowBlend whole_row(Index row) { return {{row, row, row}, {1, 0, 0}}; }

}  // namespace brindle::paraview
