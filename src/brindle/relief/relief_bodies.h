/// Closed bodies from parts of a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/mesh.h"

namespace brindle {

/// Thick bodies with two vertices for each vertex of the parts, above and below the surface.
struct ReliefBodies {
  std::vector<Triangle> triangles;
  std::vector<Index> vertices;      ///< of the surface, one per vertex of the bodies
  std::vector<std::uint8_t> below;  ///< 1 for vertices below
};

/// Bodies of two layers, joined by walls along the edges of the parts: triangles with a 1 in
/// `taken`. Parts that meet in a vertex alone have copies of it, so that each body is closed.
ReliefBodies relief_bodies(const std::vector<Triangle>& surface,
                           const std::vector<std::uint8_t>& taken);

/// The number of connected components of a mesh.
std::size_t component_count(const Mesh& mesh);

/// The volume inside a closed mesh that is wound outwards; negative if it is wound inwards.
double volume_of(const Mesh& mesh);

}  // namespace brindle
