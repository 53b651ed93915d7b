/// Which corners of which triangles meet along edges, in meshes of any topology.
#pragma once

#include <span>
#include <vector>

#include "brindle/mesh.h"

namespace brindle {

/// An edge seen from two of its triangles. Corner 3 t + c is corner c of triangle t. The corners
/// `from[0]` and `from[1]` are at one vertex, `to[0]` and `to[1]` at the other; [0] is of the
/// triangle with the lower number.
struct SharedEdge {
  std::array<Index, 2> from;
  std::array<Index, 2> to;
};

/// All edges that two triangles or more share, in ascending order of their vertices. An edge of k
/// triangles gives k - 1 entries, each with the next triangle, so that all of them are linked.
/// Throws Error if the mesh has more corners than an Index can count.
std::vector<SharedEdge> shared_edges(std::span<const Triangle> triangles);

}  // namespace brindle
