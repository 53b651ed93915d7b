/// Shortens seams: paths of edges across which orientations disagree.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// An edge that a seam may use at cost 1. Nodes are vertices, or sets of vertices between which a
/// seam moves at no cost.
struct SeamEdge {
  std::array<Index, 2> nodes;
  std::array<Index, 2> triangles;
  bool in_seam = false;
};

/// Triangles to flip (1) so that the seam becomes shorter; flipping a triangle toggles its edges in
/// the seam. The end points of a seam are fixed. Pairs of ends are joined by shortest paths,
/// nearest first, and swap partners while that helps. A path replaces the old seam where their
/// difference bounds a set of triangles. On a sphere or disc it always does, elsewhere it depends
/// on the handles. Throws Cancelled if `progress` asks for it.
std::vector<std::uint8_t> shortening_turns(std::span<const SeamEdge> edges, std::size_t node_count,
                                           std::size_t triangle_count,
                                           const Progress& progress = {});

}  // namespace brindle
