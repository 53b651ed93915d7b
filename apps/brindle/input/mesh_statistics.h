/// Statistics of meshes and point clouds.
#pragma once

#include <cstddef>

#include "brindle/mesh.h"
#include "brindle/points.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle::tool {

struct MeshStatistics {
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;      ///< of one triangle
  std::size_t non_manifold_edges = 0;  ///< of three or more triangles
  std::size_t unused_vertices = 0;     ///< without triangles
  std::size_t components = 0;          ///< connected by shared vertices
  bool orientable = true;              ///< consistent winding across manifold edges is possible
  bool wound_alike = true;             ///< and is the case
  double edge_length_mean = 0;
  double edge_length_min = 0;
  double edge_length_max = 0;
  double area = 0;
  BoundingBox box;
};

/// Throws Cancelled.
MeshStatistics mesh_statistics(const Mesh& mesh, const Progress& progress = {});

struct PointStatistics {
  std::size_t used = 0;        ///< finite, and the first at their position
  std::size_t edges = 0;       ///< between neighbours
  double neighbors_mean = 0;   ///< per point
  std::size_t components = 0;  ///< connected by neighbour relations
  double spacing_mean = 0;     ///< distances to the nearest neighbour
  double spacing_min = 0;
  double spacing_max = 0;
  BoundingBox box;  ///< of the used points
};

/// `neighborhood` is from `point_neighborhood`.
PointStatistics point_statistics(const PointCloud& cloud, const Adjacency& neighborhood);

}  // namespace brindle::tool
