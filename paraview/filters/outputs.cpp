#include "outputs.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "vtk_arrays.h"

namespace brindle::paraview {
namespace {

vtkSmartPointer<vtkPoints> empty_points(vtkPolyData& from, std::size_t count) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(from.GetPoints()->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(count));
  return points;
}

}  // namespace

vtkSmartPointer<vtkPoints> blended_points(vtkPolyData& from, std::span<const RowBlend> blends) {
  const auto points = empty_points(from, blends.size());
  for (std::size_t i = 0; i < blends.size(); ++i) {
    const auto& [rows, weights] = blends[i];
    Eigen::Vector3d place;
    from.GetPoint(rows[0], place.data());
    if (rows[0] != rows[1] || rows[1] != rows[2]) {
      place *= weights[0];
      for (const std::size_t k : {1u, 2u}) {
        Eigen::Vector3d other;
        from.GetPoint(rows[k], other.data());
        place += weights[k] * other;
      }
    }
    points->SetPoint(static_cast<vtkIdType>(i), place.data());
  }
  return points;
}

vtkSmartPointer<vtkPoints> placed_points(vtkPolyData& from, std::span<const Vec3> points,
                                         const Eigen::Vector3d& origin) {
  const auto placed = empty_points(from, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d place = points[i].cast<double>() + origin;
    placed->SetPoint(static_cast<vtkIdType>(i), place.data());
  }
  return placed;
}

vtkSmartPointer<vtkCellArray> triangle_cells(std::span<const std::array<Index, 3>> triangles) {
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(3 * static_cast<vtkIdType>(triangles.size()));
  vtkIdType at = 0;
  for (const auto& triangle : triangles) {
    for (const Index corner : triangle) corners->SetValue(at++, corner);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(3, corners);
  return cells;
}

std::vector<RowBlend> whole_rows(std::span<const Index> rows) {
  std::vector<RowBlend> blends;
  blends.reserve(rows.size());
  for (const Index row : rows) blends.push_back(whole_row(row));
  return blends;
}

void add_metrics(const PatternQuality& quality, const WaveMetrics& waves, vtkFieldData& data) {
  const auto add = [&](const char* name, double value) {
    data.AddArray(vtk_array(make_data_array(name, 1, std::vector<double>{value})));
  };
  add("branches", static_cast<double>(quality.branches));
  add("angle_error_mean_deg", quality.angle_error_mean_deg);
  add("spacing_error_mean", quality.spacing_error_mean);
  add("edges_per_period_min", waves.edges_per_period_min);
  add("edges_per_period_median", waves.edges_per_period_median);
}

}  // namespace brindle::paraview
