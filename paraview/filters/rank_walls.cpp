#include "rank_walls.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include "blocks.h"

namespace brindle::paraview {
namespace {

constexpr const char* kSolid = "brindle_has_volume";

/// Identifies a face by the three lowest numbers of its vertices.
using Face = std::array<std::uint64_t, 3>;

struct CellFaces {
  std::vector<vtkIdType> cells;
  std::vector<Face> faces;  ///< one per cell
};

/// Own faces of solids, without ghosts.
CellFaces own_faces(vtkPolyData& surface, std::span<const std::uint64_t> numbers) {
  CellFaces own;
  vtkUnsignedCharArray* flags = surface.GetCellGhostArray();
  auto* solid = vtkUnsignedCharArray::SafeDownCast(surface.GetCellData()->GetArray(kSolid));
  vtkNew<vtkIdList> corners;
  std::vector<std::uint64_t> vertices;
  for (vtkIdType cell = 0; cell < surface.GetNumberOfCells(); ++cell) {
    if (solid != nullptr && solid->GetValue(cell) == 0) continue;
    if (flags != nullptr && (flags->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0) {
      continue;
    }
    surface.GetCellPoints(cell, corners);
    if (corners->GetNumberOfIds() < 3) continue;
    vertices.clear();
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k) {
      vertices.push_back(numbers[static_cast<std::size_t>(corners->GetId(k))]);
    }
    std::ranges::sort(vertices);
    own.cells.push_back(cell);
    own.faces.push_back({vertices[0], vertices[1], vertices[2]});
  }
  return own;
}

/// Whether each face of all lists occurs twice, on any ranks.
std::vector<std::vector<std::uint8_t>> are_shared(const std::vector<std::vector<Face>>& told) {
  std::vector<Face> known;
  for (const auto& list : told) known.insert(known.end(), list.begin(), list.end());
  std::ranges::sort(known);
  std::vector<std::vector<std::uint8_t>> shared(told.size());
  for (std::size_t r = 0; r < told.size(); ++r) {
    for (const Face& face : told[r]) {
      shared[r].push_back(std::ranges::equal_range(known, face).size() > 1 ? 1 : 0);
    }
  }
  return shared;
}

vtkSmartPointer<vtkPolyData> without_cells(vtkPolyData& surface,
                                           const std::vector<vtkIdType>& cells) {
  auto rest = vtkSmartPointer<vtkPolyData>::New();
  rest->ShallowCopy(&surface);
  rest->GetCellData()->RemoveArray(kSolid);
  if (cells.empty()) return rest;
  rest->BuildCells();
  for (const vtkIdType cell : cells) rest->DeleteCell(cell);
  rest->RemoveDeletedCells();
  return rest;
}

/// 3 for cells with a volume.
int dimension_of(int cell_type, vtkGenericCell& cell) {
  cell.SetCellType(cell_type);
  return cell.GetCellDimension();
}

bool has_cells_without_volume(vtkDataSet* data) {
  if (data->GetNumberOfCells() == 0) return false;
  vtkNew<vtkGenericCell> cell;
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid == nullptr) return dimension_of(data->GetCellType(0), *cell) < 3;
  vtkUnsignedCharArray* types = grid->GetDistinctCellTypesArray();
  for (vtkIdType i = 0; i < types->GetNumberOfValues(); ++i) {
    if (dimension_of(types->GetValue(i), *cell) < 3) return true;
  }
  return false;
}

vtkSmartPointer<vtkDataSet> marked(vtkDataSet& data) {
  vtkNew<vtkUnsignedCharArray> solid;
  solid->SetName(kSolid);
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    solid->InsertNextValue(dimension_of(data.GetCellType(i), *cell) == 3 ? 1 : 0);
  }
  return with_flags(data, solid);
}

}  // namespace

bool is_grid(vtkDataObject* data) {
  return std::ranges::none_of(blocks_of(data), [](vtkDataSet* block) {
    return vtkPolyData::SafeDownCast(block) != nullptr;
  });
}

vtkSmartPointer<vtkDataObject> with_solids_marked(vtkDataObject* input) {
  if (std::ranges::none_of(blocks_of(input), has_cells_without_volume)) return input;
  return with_blocks(input, marked);
}

vtkSmartPointer<vtkPolyData> without_walls(vtkSmartPointer<vtkPolyData> surface,
                                           std::span<const std::uint64_t> numbers,
                                           const Ranks& ranks) {
  CellFaces own;
  ranks.throw_on_all([&] { own = own_faces(*surface, numbers); });
  const std::vector<std::uint8_t> shared = answers_to(
      ranks, own.faces, [&](const Face& face) { return ranks.rank_of(face); }, are_shared);
  std::vector<vtkIdType> walls;
  for (std::size_t i = 0; i < shared.size(); ++i) {
    if (shared[i] != 0) walls.push_back(own.cells[i]);
  }
  return without_cells(*surface, walls);
}

}  // namespace brindle::paraview
