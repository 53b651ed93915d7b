/// Cuts a surface into pieces for ranks.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/distributed_surface.h"
#include "brindle/mesh.h"

namespace brindle {

/// The place of a point on a Hilbert curve through the cube of 2^16 cells an edge; `cell` in that
/// cube (Skilling 2004). Points that are close on the curve are close in space.
std::uint64_t hilbert_place(std::array<std::uint32_t, 3> cell);

/// For every triangle one of `parts` ranks: equal numbers of triangles along a Hilbert curve.
std::vector<int> partition_by_curve(const Mesh& mesh, int parts);

/// A rank's triangles and their vertices, numbered as in `mesh` and in its order. Vertices that no
/// triangle uses are those of rank 0.
SurfacePiece piece_of(const Mesh& mesh, std::span<const int> rank_of_triangle, int rank);

}  // namespace brindle
