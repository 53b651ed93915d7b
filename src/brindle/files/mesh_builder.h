/// Meshes put together from what files hold: coordinates as doubles, and polygons.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/mesh.h"

namespace brindle {

class MeshBuilder {
 public:
  void reserve_vertices(std::size_t count) { positions_.reserve(count); }

  void add_vertex(const Eigen::Vector3d& position) { positions_.push_back(position); }

  /// Corners are numbers of vertices, which may be added later.
  void add_polygon(std::span<const Index> corners);

  std::size_t vertex_count() const { return positions_.size(); }
  std::span<const Eigen::Vector3d> positions() const { return positions_; }

  /// The mesh, its polygons cut into triangles in their order, about the origin that `origin_near`
  /// finds for the vertices that polygons use, or for all if there is no polygon. Leaves nothing
  /// behind.
  Mesh take();

 private:
  template <class Use>
  void for_each_polygon(const Use& use) const;

  std::vector<Eigen::Vector3d> positions_;
  std::vector<Index> polygons_;  ///< of each the number of corners, then the corners
};

}  // namespace brindle
