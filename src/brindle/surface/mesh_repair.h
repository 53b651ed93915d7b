/// Makes any list of points and triangles a valid Mesh.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "brindle/surface/mesh.h"

namespace brindle {

/// What was wrong with a mesh. Apart from `vertices_unreferenced`, nothing of it is left.
struct MeshRepair {
  std::size_t vertices_not_finite = 0;     ///< a coordinate was NaN, infinite or beyond 1e18
  std::size_t vertices_joined = 0;         ///< stood exactly where an earlier vertex stands
  std::size_t vertices_unreferenced = 0;   ///< in no triangle, after all repairs
  std::size_t triangles_out_of_range = 0;  ///< dropped: named a vertex that does not exist
  std::size_t triangles_not_finite = 0;    ///< dropped: used a vertex that is not finite
  std::size_t triangles_degenerate = 0;    ///< dropped: two corners alike, or no area
  std::size_t triangles_duplicate = 0;     ///< dropped: had the corners of an earlier one

  /// Whether triangles were dropped or positions replaced.
  bool changed() const {
    return vertices_not_finite + triangles_out_of_range + triangles_not_finite +
               triangles_degenerate + triangles_duplicate >
           0;
  }

  bool operator==(const MeshRepair&) const = default;
};

/// One line per finding, as for a report to the user; empty if there are none.
std::string describe(const MeshRepair& repair);

/// Drops triangles that cannot be used. Vertices stay, and keep their numbers, so that data per
/// vertex still match: those that are not finite are moved to the centroid of the others.
MeshRepair repair_mesh(Mesh& mesh);

/// Moves positions with a coordinate that is NaN, infinite or beyond 1e18 to the centroid of the
/// others. Returns, for every position, whether it was good.
std::vector<char> set_positions_finite(std::vector<Vec3>& positions);

/// Lets triangles use, of all vertices at exactly the same place, the one with the smallest number.
/// The others stay, in no triangle. Returns how many there are.
std::size_t join_vertices(Mesh& mesh);

/// For every position the first that is exactly the same; itself for one that is no good.
std::vector<Index> first_at_each_place(std::span<const Vec3> positions);

/// As above, with what `first_at_each_place` found.
std::size_t join_vertices(Mesh& mesh, std::span<const Index> first);

/// Removes vertices that no triangle uses; the others are renumbered in order. Returns the new
/// number of every vertex that is left.
std::vector<Index> drop_unreferenced_vertices(Mesh& mesh);

}  // namespace brindle
