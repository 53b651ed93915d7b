/// Points, cells and metrics of outputs.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <brindle/data_arrays.h>
#include <brindle/quality.h>
#include <brindle/types.h>
#include <brindle/wave_metrics.h>
#include <vtkSmartPointer.h>

class vtkCellArray;
class vtkFieldData;
class vtkPoints;
class vtkPolyData;

namespace brindle::paraview {

/// A point per blend of the points of `from`, in their type.
vtkSmartPointer<vtkPoints> blended_points(vtkPolyData& from, std::span<const RowBlend> blends);

/// Points relative to an origin, in the type of those of `from`.
vtkSmartPointer<vtkPoints> placed_points(vtkPolyData& from, std::span<const Vec3> points,
                                         const Eigen::Vector3d& origin);

vtkSmartPointer<vtkCellArray> triangle_cells(std::span<const std::array<Index, 3>> triangles);

/// A blend per row.
std::vector<RowBlend> whole_rows(std::span<const Index> rows);

/// Adds branches, angle_error_mean_deg, spacing_error_mean, edges_per_period_min and
/// edges_per_period_median of a whole pattern.
void add_metrics(const PatternQuality& quality, const WaveMetrics& waves, vtkFieldData& data);

}  // namespace brindle::paraview
