/// Closed bodies from parts of a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/mesh.h"

namespace brindle {

/// The vertices of thick bodies: two for each vertex of the parts, above and below the surface.
struct ReliefBodies {
  Mesh mesh;                        ///< positions are those of the surface
  std::vector<Index> vertices;      ///< of the surface, one per vertex of the mesh
  std::vector<std::uint8_t> below;  ///< 1 for vertices below
};

/// Bodies of two layers, joined by walls along the edges of the parts: triangles with a 1 in
/// `taken`. Parts that meet in a vertex alone have copies of it, so that each body is closed.
ReliefBodies relief_bodies(const Mesh& surface, const std::vector<std::uint8_t>& taken);

/// The number of connected components of a mesh.
std::size_t component_count(const Mesh& mesh);

}  // namespace brindle
