/// Closed ways along the edges of a surface: its boundaries, and one for each way round a handle.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "brindle/export.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

struct SurfaceLoop {
  /// "boundary-1", "boundary-2" and so on in the order of their lowest vertices; "loop-1" and so on
  /// for handles, the shortest first.
  std::string name;
  bool boundary = false;
  /// In order, the first not repeated. The surface lies to the left of a boundary where triangles
  /// are wound alike.
  std::vector<Index> vertices;
  double length = 0;  ///< in units of length
  /// The mean place along the loop, relative to the mesh's origin: boundaries are told apart by it.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  std::size_t component = 0;  ///< which connected piece of the surface, from 0
};

/// All boundary loops, then for every handle its two loops (for every cross-cap its one): together
/// they generate all ways round on the surface. Loops of handles are the shortest of those that a
/// tree of shortest ways from one vertex of each piece allows (Erickson and Whittlesey 2005). A
/// piece with an edge of three triangles or more has none; nor have points without triangles.
std::vector<SurfaceLoop> surface_loops(const Surface& surface);

}  // namespace brindle
