#include "surface_places.h"

#include <vector>

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "vtk_arrays.h"

namespace brindle::paraview {

void carry_to_places(const InputSurface& input, std::span<const TrianglePoint> places,
                     vtkPointData& points) {
  std::vector<RowBlend> of_points, of_cells;
  for (const TrianglePoint& place : places) {
    of_points.push_back({input.points_of_triangle[place.triangle], place.barycentric});
    of_cells.push_back(whole_row(input.cell_of_triangle[place.triangle]));
  }
  carry(*input.triangles->GetPointData(), of_points, points);
  carry(*input.triangles->GetCellData(), of_cells, points);
}

}  // namespace brindle::paraview
