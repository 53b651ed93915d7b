#include "surface_cache.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <brindle/error.h>
#include <brindle/mesh_data.h>
#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include "vtk_arrays.h"

namespace brindle::paraview {
namespace {

template <class Filter>
vtkSmartPointer<vtkPolyData> filtered(Filter& filter, vtkDataObject* input, vtkAlgorithm* owner) {
  filter.SetContainerAlgorithm(owner);
  filter.SetInputDataObject(input);
  filter.Update();
  return filter.GetOutput();
}

vtkSmartPointer<vtkPolyData> polygons_of(vtkDataObject* input, vtkAlgorithm* owner) {
  if (auto* polygons = vtkPolyData::SafeDownCast(input)) return polygons;
  if (vtkCompositeDataSet::SafeDownCast(input) != nullptr) {
    vtkNew<vtkCompositeDataGeometryFilter> outside;
    return filtered(*outside, input, owner);
  }
  if (vtkDataSet::SafeDownCast(input) != nullptr) {
    vtkNew<vtkDataSetSurfaceFilter> outside;
    return filtered(*outside, input, owner);
  }
  throw Error("the input has no surface");
}

/// Throws Error for cells that name points which do not exist: VTK's own filters would look there.
void check_corners(vtkPolyData& data) {
  for (vtkCellArray* cells : {data.GetPolys(), data.GetStrips()}) {
    if (cells == nullptr || cells->GetNumberOfConnectivityIds() == 0) continue;
    double range[2];
    cells->GetConnectivityArray()->GetRange(range);
    if (range[0] >= 0 && range[1] < static_cast<double>(data.GetNumberOfPoints())) continue;
    const auto wrong = static_cast<vtkIdType>(range[0] < 0 ? range[0] : range[1]);
    throw Error("a polygon has the corner " + std::to_string(wrong) + ", but there are " +
                std::to_string(data.GetNumberOfPoints()) + " points");
  }
}

/// Whether every cell is a triangle.
bool are_triangles(vtkPolyData& data) {
  return data.GetNumberOfCells() == data.GetNumberOfPolys() &&
         data.GetPolys()->IsHomogeneous() == 3;
}

vtkSmartPointer<vtkPolyData> triangles_of(vtkDataObject* input, vtkAlgorithm* owner) {
  vtkSmartPointer<vtkPolyData> polygons = polygons_of(input, owner);
  if (polygons->GetNumberOfPoints() == 0 || are_triangles(*polygons)) return polygons;
  check_corners(*polygons);
  vtkNew<vtkTriangleFilter> cut;
  cut->PassVertsOff();
  cut->PassLinesOff();
  return filtered(*cut, polygons, owner);
}

/// Numbers of cells' corners in rows of three.
DataArray corners_of(vtkPolyData& data) {
  DataArray corners = data_array_of(*data.GetPolys()->GetConnectivityArray());
  corners.components = 3;
  return corners;
}

Mesh raw_mesh(vtkPolyData& data) {
  const DataArray positions = data_array_of(*data.GetPoints()->GetData());
  return make_mesh(positions.view(), corners_of(data).view());
}

bool same(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles && a.origin == b.origin;
}

}  // namespace

DataArray InputSurface::array(const std::string& name, bool of_points) const {
  vtkDataSetAttributes* attributes =
      of_points ? static_cast<vtkDataSetAttributes*>(triangles->GetPointData())
                : triangles->GetCellData();
  vtkDataArray* found = attributes->GetArray(name.c_str());
  if (found == nullptr) {
    throw Error("the surface has no array '" + name + "' of numbers per " +
                (of_points ? "point" : "cell"));
  }
  DataArray rows = data_array_of(*found);
  if (!of_points) return cells_to_points(surface->mesh, rows_of(rows, cell_of_triangle));
  return joined ? rows_of(rows, vertex_of_point) : std::move(rows);
}

const InputSurface* SurfaceCache::surface_of(vtkDataObject* input, vtkAlgorithm* owner) {
  vtkSmartPointer<vtkPolyData> triangles = triangles_of(input, owner);
  if (triangles->GetNumberOfPoints() == 0) return nullptr;
  if (triangles->GetNumberOfPolys() == 0) {
    throw Error("the input has points, but no surface: stripes need polygons");
  }
  const Stamp stamp{
      triangles->GetPoints()->GetData(), triangles->GetPolys(),
      std::max(triangles->GetPoints()->GetMTime(), triangles->GetPolys()->GetMTime())};
  if (!current_.surface || stamp != stamp_) {
    Mesh raw = raw_mesh(*triangles);
    if (!current_.surface || !same(raw, raw_)) {
      derive(raw);
      raw_ = std::move(raw);
    }
    stamp_ = stamp;
  }
  current_.triangles = triangles;  // with this input's arrays
  return &current_;
}

void SurfaceCache::derive(const Mesh& raw) {
  current_ = {};
  InputSurface made;
  Mesh mesh = raw;
  made.vertex_of_point = first_at_each_place(mesh.positions);
  made.joined = join_vertices(mesh, made.vertex_of_point) > 0;
  repair_mesh(mesh, made.cell_of_triangle);
  for (const Index cell : made.cell_of_triangle) {
    made.points_of_triangle.push_back(raw.triangles[cell]);
  }
  if (mesh.triangles.empty()) throw Error("the input's surface has no triangle with an area");
  made.surface = std::make_shared<const Surface>(make_surface(std::move(mesh)));
  current_ = std::move(made);
  ++surfaces_made_;
}

}  // namespace brindle::paraview
