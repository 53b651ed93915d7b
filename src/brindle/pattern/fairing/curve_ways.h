/// Lines on a mesh as pieces within its triangles.
#pragma once

#include <vector>

#include "brindle/geometry/surface_walk.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/polylines.h"

namespace brindle {

/// Appends the pieces of a way between two places near to each other, upright on the surface; where
/// that does not lead there, one piece with the place beside its triangle moved onto it. Pieces no
/// longer than `least` are left out.
void add_way(const WavePattern& pattern, const SurfaceWays& ways, const TrianglePoint& from,
             const TrianglePoint& to, double least, std::vector<SurfaceWays::Piece>& pieces);

/// Appends the points of a line to others, with their places; no line ends there yet.
void add_points_of(const WavePattern& pattern, const std::vector<SurfaceWays::Piece>& pieces,
                   bool closed, Polylines& to);

/// The pieces of one of the lines.
std::vector<SurfaceWays::Piece> pieces_of(const Polylines& lines, Index line);

}  // namespace brindle
