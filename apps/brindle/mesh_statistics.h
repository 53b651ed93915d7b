/// What kind of surface a mesh is.
#pragma once

#include <cstddef>

#include "brindle/mesh.h"

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

MeshStatistics mesh_statistics(const Mesh& mesh);

}  // namespace brindle::tool
