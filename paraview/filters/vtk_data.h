/// Converts arrays, points and cells between VTK and the library.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <brindle/arrays.h>
#include <brindle/data_arrays.h>
#include <brindle/quality.h>
#include <brindle/types.h>
#include <brindle/wave_metrics.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkCellArray;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkFieldData;
class vtkPoints;
class vtkPolyData;

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

/// A blend per row.
std::vector<RowBlend> whole_rows(std::span<const Index> rows);

/// A point per blend of the points of `from`, in their type.
vtkSmartPointer<vtkPoints> blended_points(vtkPolyData& from, std::span<const RowBlend> blends);

/// Points relative to an origin, in the type of those of `from`.
vtkSmartPointer<vtkPoints> placed_points(vtkPolyData& from, std::span<const Vec3> points,
                                         const Eigen::Vector3d& origin);

vtkSmartPointer<vtkCellArray> triangle_cells(std::span<const std::array<Index, 3>> triangles);

/// Adds branches, angle_error_mean_deg, spacing_error_mean, edges_per_period_min and
/// edges_per_period_median of a whole pattern.
void add_metrics(const PatternQuality& quality, const WaveMetrics& waves, vtkFieldData& data);

}  // namespace brindle::paraview
