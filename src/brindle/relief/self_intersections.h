/// Detection and removal of triangles that intersect others of the same mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// 1 for every triangle that an edge of another one crosses, or whose edge crosses another one,
/// away from common vertices, and for neighbours folded onto each other. Triangles that only touch
/// do not intersect. The test is exact, for coordinates rounded to 2^-40 of the largest one: only
/// those below 2^-16 of it change. Throws Cancelled if `progress` cancels.
std::vector<std::uint8_t> intersecting_triangles(const Mesh& mesh, const Progress& progress = {});

/// A mesh whose vertices were moved along lines.
struct RaisedMesh {
  std::vector<Triangle> triangles;
  std::vector<Vec3> rest;      ///< places for height 0
  std::vector<Vec3> ways;      ///< displacements for height 1
  std::vector<float> heights;  ///< 0 or more
  float least_share = 0;       ///< of its height that a vertex keeps

  std::vector<Vec3> positions() const;
};

/// Lowers the vertices of triangles that intersect others, first by halves, until none do or all of
/// these have the least height. Returns the number of triangles that still intersect others. The
/// result does not depend on the number of threads. Throws Cancelled if `progress` cancels.
std::size_t lower_intersections(RaisedMesh& mesh, const Progress& progress);

}  // namespace brindle
