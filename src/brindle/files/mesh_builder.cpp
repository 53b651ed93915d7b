#include "brindle/files/mesh_builder.h"

#include <algorithm>
#include <utility>

#include "brindle/local_positions.h"
#include "brindle/mesh.h"

namespace brindle {
namespace {

/// Reserves for `more` entries, at least doubling the capacity, so that many calls cost no more
/// than one.
template <class Entry>
void make_room(std::vector<Entry>& entries, std::size_t more) {
  const std::size_t wanted = entries.size() + more;
  if (wanted > entries.capacity()) entries.reserve(std::max(wanted, 2 * entries.capacity()));
}

/// Expands rows of cells to rows of triangles.
void spread_over_triangles(std::vector<DataArray>& cells, std::span<const Index> cell_of_triangle) {
  for (DataArray& array : cells) {
    bool alike = array.rows() == cell_of_triangle.size();
    for (std::size_t t = 0; alike && t < cell_of_triangle.size(); ++t) {
      alike = cell_of_triangle[t] == t;
    }
    if (!alike) array = rows_of(array, cell_of_triangle);
  }
}

}  // namespace

void MeshBuilder::reserve_vertices(std::size_t more) { make_room(positions_, more); }

void MeshBuilder::reserve_polygons(std::size_t more, std::size_t corners) {
  make_room(polygons_, more + corners);
  make_room(cells_, more);
}

void MeshBuilder::add_polygon(std::span<const Index> corners, Index cell) {
  polygons_.push_back(static_cast<Index>(corners.size()));
  polygons_.insert(polygons_.end(), corners.begin(), corners.end());
  cells_.push_back(cell);
}

void MeshBuilder::add_strip(std::span<const Index> corners, Index cell) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Index a = corners[i - 2], b = corners[i - 1], c = corners[i];
    if (a == b || b == c || c == a) continue;
    add_polygon(i % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c}, cell);
  }
}

template <class Use>
void MeshBuilder::for_each_polygon(const Use& use) const {
  for (std::size_t at = 0; at < polygons_.size(); at += 1 + polygons_[at]) {
    use(std::span(polygons_).subspan(at + 1, polygons_[at]));
  }
}

RawMesh MeshBuilder::take(DataArrays arrays, std::vector<Eigen::Vector3d>* exact) {
  std::vector<char> used(polygons_.empty() ? 0 : positions_.size(), 0);
  for_each_polygon([&](std::span<const Index> corners) {
    for (const Index corner : corners) used[corner] = 1;
  });
  Mesh mesh;
  mesh.origin = origin_near(positions_, used);
  mesh.positions = positions_about(mesh.origin, positions_);
  if (exact) *exact = std::move(positions_);
  positions_ = {};
  std::vector<Index> cell_of_triangle;
  cell_of_triangle.reserve(cells_.size());
  mesh.triangles.reserve(cells_.size());
  std::size_t polygon = 0;
  CrossedPolygons crossed;
  for_each_polygon([&](std::span<const Index> corners) {
    const Index cell = cells_[polygon++];
    if (!triangulate_polygon(mesh.positions, corners, mesh.triangles)) crossed.add(cell);
    cell_of_triangle.resize(mesh.triangle_count(), cell);
  });
  polygons_ = {};
  cells_ = {};
  spread_over_triangles(arrays.cells, cell_of_triangle);
  RawMesh raw{std::move(mesh), std::move(arrays)};
  raw.taken = describe(crossed);
  return raw;
}

}  // namespace brindle
