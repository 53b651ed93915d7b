#include "rank_walls.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

namespace brindle::paraview {
namespace {

constexpr const char* kSolid = "brindle_has_volume";

/// Identifies a face by the three lowest numbers of its vertices.
using Face = std::array<std::uint64_t, 3>;

std::uint64_t hash(const Face& face) {
  std::uint64_t h = 0;
  for (const std::uint64_t number : face) {
    h = (h ^ number) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  }
  return h;
}

/// Own faces of solids, without ghosts, and their cell numbers.
std::vector<std::pair<vtkIdType, Face>> own_faces(vtkPolyData& surface,
                                                  std::span<const std::uint64_t> numbers) {
  std::vector<std::pair<vtkIdType, Face>> faces;
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
    faces.push_back({cell, {vertices[0], vertices[1], vertices[2]}});
  }
  return faces;
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

bool has_cells_without_volume(vtkDataObject* leaf) {
  auto* data = vtkDataSet::SafeDownCast(leaf);
  if (data == nullptr || data->GetNumberOfCells() == 0) return false;
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
  auto copy = vtkSmartPointer<vtkDataSet>::Take(data.NewInstance());
  copy->ShallowCopy(&data);
  copy->GetCellData()->AddArray(solid);
  return copy;
}

}  // namespace

bool is_grid(vtkDataObject* data) {
  auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (blocks == nullptr) return vtkPolyData::SafeDownCast(data) == nullptr;
  const auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem()) {
    if (vtkPolyData::SafeDownCast(block->GetCurrentDataObject()) != nullptr) return false;
  }
  return true;
}

vtkSmartPointer<vtkDataObject> with_solids_marked(vtkDataObject* input) {
  auto* blocks = vtkCompositeDataSet::SafeDownCast(input);
  if (blocks == nullptr) {
    if (!has_cells_without_volume(input)) return input;
    return marked(*vtkDataSet::SafeDownCast(input));
  }
  bool any = false;
  const auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem()) {
    any = any || has_cells_without_volume(block->GetCurrentDataObject());
  }
  if (!any) return input;
  auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(blocks->NewInstance());
  copy->CopyStructure(blocks);
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem()) {
    auto* data = vtkDataSet::SafeDownCast(block->GetCurrentDataObject());
    if (data != nullptr) copy->SetDataSet(block, marked(*data));
  }
  return copy;
}

vtkSmartPointer<vtkPolyData> without_walls(vtkSmartPointer<vtkPolyData> surface,
                                           std::span<const std::uint64_t> numbers,
                                           const Ranks& ranks) {
  std::vector<std::pair<vtkIdType, Face>> faces;
  ranks.throw_on_all([&] { faces = own_faces(*surface, numbers); });
  std::vector<std::vector<Face>> told(static_cast<std::size_t>(ranks.size()));
  for (const auto& [cell, face] : faces) told[hash(face) % told.size()].push_back(face);
  const auto answers = ranks.swap_lists(are_shared(ranks.swap_lists(told)));

  std::vector<std::size_t> next(told.size());
  std::vector<vtkIdType> walls;
  for (const auto& [cell, face] : faces) {
    const std::size_t knows = hash(face) % told.size();
    if (answers[knows][next[knows]++] != 0) walls.push_back(cell);
  }
  return without_cells(*surface, walls);
}

}  // namespace brindle::paraview
