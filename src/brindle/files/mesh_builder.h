/// Meshes put together from what files hold: coordinates as doubles, and polygons.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/files/raw_mesh.h"
#include "brindle/mesh.h"

namespace brindle {

class MeshBuilder {
 public:
  /// Makes room for so many more vertices.
  void reserve_vertices(std::size_t more);

  /// Makes room for so many more polygons with so many corners in all.
  void reserve_polygons(std::size_t more, std::size_t corners);

  void add_vertex(const Eigen::Vector3d& position) { positions_.push_back(position); }

  /// Corners are numbers of vertices, which may be added later. `cell` is the polygon's row in the
  /// file's data per cell.
  void add_polygon(std::span<const Index> corners, Index cell = 0);

  /// A triangle of every corner and the two before it, wound the other way round each time. Corners
  /// that repeat turn strips around or join them, and make no triangle of their own.
  void add_strip(std::span<const Index> corners, Index cell = 0);

  std::size_t vertex_count() const { return positions_.size(); }
  std::span<const Eigen::Vector3d> positions() const { return positions_; }

  /// The mesh, its polygons cut into triangles in their order, about the origin that `origin_near`
  /// finds for the vertices that polygons use, or for all if there is no polygon. Leaves nothing
  /// behind.
  Mesh take();

  /// The same with what the file says of it: `arrays` has a row per vertex and per cell, and the
  /// result one per vertex and per triangle. `exact` receives the coordinates as they were added.
  RawMesh take(DataArrays arrays, std::vector<Eigen::Vector3d>* exact = nullptr);

 private:
  template <class Use>
  void for_each_polygon(const Use& use) const;

  std::vector<Eigen::Vector3d> positions_;
  std::vector<Index> polygons_;  ///< of each the number of corners, then the corners
  std::vector<Index> cells_;     ///< of each polygon
};

}  // namespace brindle
