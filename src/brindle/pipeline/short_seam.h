/// Short seams: paths along edges at which the sides of a surface do not fit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// An edge that a seam may run along, at the cost of 1. Nodes are its ends: vertices, or several of
/// them where a seam may jump from one to the other without cost.
struct SeamEdge {
  std::array<Index, 2> nodes;
  std::array<Index, 2> triangles;
  bool in_seam = false;
};

/// Which triangles to turn (1) so that the seam becomes shorter; turning a triangle puts each of
/// its edges into the seam or takes it out. The points where the seam ends cannot move: pairs of
/// them are joined by shortest paths, near ones first, and pairs swap ends while that helps. Paths
/// are taken over where they differ from the seam by the border of a set of triangles: on a sphere
/// or a disc that is everywhere, on other surfaces it depends on how a path runs around handles.
/// Throws Cancelled if `progress` asks for it.
std::vector<std::uint8_t> shortening_turns(std::span<const SeamEdge> edges, std::size_t node_count,
                                           std::size_t triangle_count,
                                           const Progress& progress = {});

}  // namespace brindle
