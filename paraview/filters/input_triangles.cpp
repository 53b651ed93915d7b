#include "input_triangles.h"

#include <algorithm>
#include <span>
#include <string>

#include <brindle/data_arrays.h>
#include <brindle/error.h>
#include <brindle/mesh.h>
#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include "blocks.h"
#include "vtk_data.h"

namespace brindle::paraview {
namespace {

template <class Filter>
vtkSmartPointer<vtkPolyData> filtered(Filter& filter, vtkDataObject* input, vtkAlgorithm* owner) {
  filter.SetContainerAlgorithm(owner);
  filter.SetInputDataObject(input);
  filter.Update();
  return filter.GetOutput();
}

/// Throws Error for corners that do not exist, which VTK's own filters would read.
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

/// Corner numbers of cells, in rows of three.
DataArray corners_of(vtkPolyData& data) {
  DataArray corners = data_array_of(*data.GetPolys()->GetConnectivityArray());
  corners.components = 3;
  return corners;
}

/// 1 for VTK's ghost triangles.
std::vector<std::uint8_t> ghosts_of(vtkPolyData& triangles) {
  std::vector<std::uint8_t> ghosts;
  vtkUnsignedCharArray* flags = triangles.GetCellGhostArray();
  if (flags == nullptr) return ghosts;
  for (vtkIdType cell = 0; cell < triangles.GetNumberOfCells(); ++cell) {
    ghosts.push_back((flags->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0 ? 1 : 0);
  }
  return ghosts;
}

/// The same data without ghost flags.
vtkSmartPointer<vtkDataSet> without_ghosts(vtkDataSet& data) {
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  flags->SetNumberOfValues(data.GetNumberOfCells());
  flags->Fill(0);
  return with_flags(data, flags);
}

/// Triangles, and the cell number of the polygon of each.
struct CutCells {
  std::vector<Triangle> triangles;
  std::vector<Index> cells;
};

void cut_polygons(vtkCellArray& polygons, Index first_cell, std::span<const Vec3> positions,
                  CutCells& cut) {
  std::vector<Index> corners;
  for (vtkIdType cell = 0; cell < polygons.GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    polygons.GetCellAtId(cell, count, points);
    corners.assign(points, points + count);
    triangulate_polygon(positions, corners, cut.triangles);
    cut.cells.resize(cut.triangles.size(), first_cell + static_cast<Index>(cell));
  }
}

/// Every other triangle of a strip has the opposite winding.
void take_strips_apart(vtkCellArray& strips, Index first_cell, CutCells& cut) {
  for (vtkIdType cell = 0; cell < strips.GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    strips.GetCellAtId(cell, count, points);
    for (vtkIdType i = 0; i + 2 < count; ++i) {
      const bool turned = i % 2 == 1;
      cut.triangles.push_back({static_cast<Index>(points[i]),
                               static_cast<Index>(points[turned ? i + 2 : i + 1]),
                               static_cast<Index>(points[turned ? i + 1 : i + 2])});
    }
    cut.cells.resize(cut.triangles.size(), first_cell + static_cast<Index>(cell));
  }
}

}  // namespace

vtkSmartPointer<vtkDataObject> with_ghosts_of_all(vtkDataObject* input) {
  const auto has_ghosts = [](vtkDataSet* block) { return block->GetCellGhostArray() != nullptr; };
  if (std::ranges::none_of(blocks_of(input), has_ghosts)) return input;
  return with_blocks(input, [&](vtkDataSet& block) -> vtkSmartPointer<vtkDataSet> {
    if (has_ghosts(&block)) return &block;
    return without_ghosts(block);
  });
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

std::vector<Vec3> positions_about(const Eigen::Vector3d& origin, vtkPolyData& data) {
  std::vector<Vec3> positions;
  positions.reserve(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    Eigen::Vector3d p;
    data.GetPoint(i, p.data());
    positions.emplace_back((p - origin).cast<float>());
  }
  return positions;
}

std::vector<std::int64_t> ids_of(vtkPolyData& triangles) {
  std::vector<std::int64_t> ids;
  vtkDataArray* found = triangles.GetPointData()->GetGlobalIds();
  if (found == nullptr || found->GetNumberOfComponents() != 1) return ids;
  for (vtkIdType point = 0; point < found->GetNumberOfTuples(); ++point) {
    ids.push_back(static_cast<std::int64_t>(found->GetVariantValue(point).ToLongLong()));
  }
  return ids;
}

vtkSmartPointer<vtkPolyData> triangles_of(vtkSmartPointer<vtkPolyData> polygons,
                                          const Eigen::Vector3d& origin) {
  if (polygons->GetNumberOfPoints() == 0 || are_triangles(*polygons)) return polygons;
  check_corners(*polygons);
  // VTK's order of cells.
  const vtkIdType first_polygon = polygons->GetNumberOfVerts() + polygons->GetNumberOfLines();
  const vtkIdType first_strip = first_polygon + polygons->GetNumberOfPolys();
  CutCells cut;
  cut_polygons(*polygons->GetPolys(), static_cast<Index>(first_polygon),
               positions_about(origin, *polygons), cut);
  take_strips_apart(*polygons->GetStrips(), static_cast<Index>(first_strip), cut);
  auto triangles = vtkSmartPointer<vtkPolyData>::New();
  triangles->SetPoints(polygons->GetPoints());
  triangles->SetPolys(triangle_cells(cut.triangles));
  triangles->GetPointData()->PassData(polygons->GetPointData());
  triangles->GetFieldData()->PassData(polygons->GetFieldData());
  carry(*polygons->GetCellData(), whole_rows(cut.cells), *triangles->GetCellData());
  return triangles;
}

RawMesh raw_mesh(vtkPolyData& triangles) {
  if (triangles.GetNumberOfPoints() == 0) return {};
  const DataArray positions = data_array_of(*triangles.GetPoints()->GetData());
  // Repeated triangles are dropped later, with ghosts and ranks.
  return {make_mesh(positions.view(), corners_of(triangles).view(), BadTriangles::kept),
          ghosts_of(triangles), ids_of(triangles)};
}

bool same(const RawMesh& a, const RawMesh& b) {
  return a.mesh.positions == b.mesh.positions && a.mesh.triangles == b.mesh.triangles &&
         a.mesh.origin == b.mesh.origin && a.ghosts == b.ghosts && a.ids == b.ids;
}

}  // namespace brindle::paraview
