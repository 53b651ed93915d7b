/// What kind of surface a mesh or a point cloud is.
#pragma once

#include <cstddef>

#include "brindle/mesh.h"
#include "brindle/points.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle::tool {

struct MeshStatistics {
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;      ///< with one triangle
  std::size_t non_manifold_edges = 0;  ///< with three or more
  std::size_t unused_vertices = 0;     ///< without a triangle
  std::size_t components = 0;          ///< connected over common vertices
  bool orientable = true;              ///< all triangles can be wound alike over manifold edges
  bool wound_alike = true;             ///< and they are
  double edge_length_mean = 0;
  double edge_length_min = 0;
  double edge_length_max = 0;
  double area = 0;
  BoundingBox box;
};

/// Throws Cancelled if `progress` asks for it.
MeshStatistics mesh_statistics(const Mesh& mesh, const Progress& progress = {});

struct PointStatistics {
  std::size_t used = 0;        ///< finite, and the first at their place
  std::size_t edges = 0;       ///< between neighbours
  double neighbors_mean = 0;   ///< of a point
  std::size_t components = 0;  ///< connected over neighbours
  double spacing_mean = 0;     ///< distances to the nearest neighbour
  double spacing_min = 0;
  double spacing_max = 0;
  BoundingBox box;  ///< of the points used
};

/// `neighborhood` as `point_neighborhood` makes it.
PointStatistics point_statistics(const PointCloud& cloud, const Adjacency& neighborhood);

}  // namespace brindle::tool
