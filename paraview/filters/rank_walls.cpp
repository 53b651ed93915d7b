#include "rank_walls.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

namespace brindle::paraview {
namespace {

using Point = std::array<double, 3>;

/// What tells a face: the first three of its points, from left to right; no other face has them.
struct Face {
  std::array<Point, 3> points;

  auto operator<=>(const Face&) const = default;
};

std::uint64_t hash(const Face& face) {
  std::uint64_t h = 0;
  for (const Point& point : face.points) {
    for (const double coordinate : point) {
      h = (h ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
  }
  return h;
}

/// Own faces, ghosts left out, and the numbers of their cells.
std::vector<std::pair<vtkIdType, Face>> own_faces(vtkPolyData& surface) {
  std::vector<std::pair<vtkIdType, Face>> faces;
  vtkUnsignedCharArray* flags = surface.GetCellGhostArray();
  vtkNew<vtkIdList> corners;
  std::vector<Point> points;
  for (vtkIdType cell = 0; cell < surface.GetNumberOfCells(); ++cell) {
    if (flags != nullptr && (flags->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0) {
      continue;
    }
    surface.GetCellPoints(cell, corners);
    if (corners->GetNumberOfIds() < 3) continue;
    points.clear();
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k) {
      Point& point = points.emplace_back();
      surface.GetPoint(corners->GetId(k), point.data());
      for (double& coordinate : point) coordinate += 0.0;  // -0 is 0
    }
    std::ranges::sort(points);
    faces.push_back({cell, {{points[0], points[1], points[2]}}});
  }
  return faces;
}

/// For every face of every rank's list: whether another rank has it.
std::vector<std::vector<std::uint8_t>> are_shared(const std::vector<std::vector<Face>>& told) {
  std::vector<std::pair<Face, std::size_t>> known;
  for (std::size_t r = 0; r < told.size(); ++r) {
    for (const Face& face : told[r]) known.emplace_back(face, r);
  }
  std::ranges::sort(known);
  std::vector<std::vector<std::uint8_t>> shared(told.size());
  for (std::size_t r = 0; r < told.size(); ++r) {
    for (const Face& face : told[r]) {
      const auto same =
          std::ranges::equal_range(known, face, {}, &std::pair<Face, std::size_t>::first);
      shared[r].push_back(same.front().second != same.back().second ? 1 : 0);
    }
  }
  return shared;
}

vtkSmartPointer<vtkPolyData> without_cells(vtkPolyData& surface,
                                           const std::vector<vtkIdType>& cells) {
  auto rest = vtkSmartPointer<vtkPolyData>::New();
  rest->ShallowCopy(&surface);
  rest->BuildCells();
  for (const vtkIdType cell : cells) rest->DeleteCell(cell);
  rest->RemoveDeletedCells();
  return rest;
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

vtkSmartPointer<vtkPolyData> without_walls(vtkSmartPointer<vtkPolyData> surface,
                                           const Ranks& ranks) {
  std::vector<std::pair<vtkIdType, Face>> faces;
  ranks.together([&] { faces = own_faces(*surface); });
  std::vector<std::vector<Face>> told(static_cast<std::size_t>(ranks.size()));
  for (const auto& [cell, face] : faces) told[hash(face) % told.size()].push_back(face);
  const auto answers = ranks.swap_lists(are_shared(ranks.swap_lists(told)));

  std::vector<std::size_t> next(told.size());
  std::vector<vtkIdType> walls;
  for (const auto& [cell, face] : faces) {
    const std::size_t knows = hash(face) % told.size();
    if (answers[knows][next[knows]++] != 0) walls.push_back(cell);
  }
  if (walls.empty()) return surface;
  return without_cells(*surface, walls);
}

}  // namespace brindle::paraview
