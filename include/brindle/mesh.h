/// A triangle surface: points and triangles, of any topology.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "brindle/arrays.h"
#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Three vertex numbers, counter-clockwise seen from outside where the surface has an outside.
using Triangle = std::array<Index, 3>;

/// A triangle mesh of any topology: open, non-manifold, unorientable, with several components, and
/// with vertices that no triangle uses. Positions are finite; triangle corners are in range and
/// different from each other. `repair_mesh` ensures that.
struct Mesh {
  std::vector<Vec3> positions;  ///< relative to `origin`
  std::vector<Triangle> triangles;
  /// The absolute place of the positions' zero. Floats lose the shape of small meshes far from
  /// zero. Files with such coordinates are therefore read relative to a point nearby and written
  /// back in place.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();

  std::size_t vertex_count() const { return positions.size(); }
  std::size_t triangle_count() const { return triangles.size(); }
};

/// Axis-aligned box around all vertices in triangles, or around all vertices if there is no
/// triangle; both corners are zero if there is no vertex.
struct BoundingBox {
  Vec3 lower = Vec3::Zero();
  Vec3 upper = Vec3::Zero();

  Vec3 center() const { return 0.5f * (lower + upper); }
  float diagonal() const { return (upper - lower).norm(); }
};

BoundingBox bounding_box(const Mesh& mesh);

/// How `make_mesh` treats triangles that have two equal corners or occur twice.
enum class BadTriangles {
  refused,
  kept  ///< for `repair_mesh`, or if no pattern is made
};

/// A mesh from another program's arrays: three coordinates per vertex, three vertex numbers from 0
/// per triangle, signed or not. Vertices and triangles keep their numbers. Coordinates that are
/// large against the mesh's size are made relative to `Mesh::origin`. Coincident vertices stay
/// separate, and so do the triangles on both sides: `surface_warnings` reports them,
/// `make_repaired_mesh` joins them. Throws Error, naming the first vertex or triangle and the
/// remedy, for coordinates that are not finite or beyond 1e18, corners that are no vertices,
/// triangles with two equal corners or the corners of an earlier one, arrays without three columns,
/// and corners that are not whole numbers. Throws Cancelled if `progress` cancels.
Mesh make_mesh(const ArrayView& positions, const ArrayView& triangles,
               BadTriangles bad = BadTriangles::refused, const Progress& progress = {});

/// Defects of a mesh. All are repaired, except `vertices_unreferenced`.
struct MeshRepair {
  std::size_t vertices_not_finite = 0;     ///< a coordinate was NaN, infinite or beyond 1e18
  std::size_t vertices_joined = 0;         ///< at exactly the position of an earlier vertex
  std::size_t vertices_unreferenced = 0;   ///< in no triangle, after all repairs
  std::size_t triangles_out_of_range = 0;  ///< dropped: named a vertex that does not exist
  std::size_t triangles_not_finite = 0;    ///< dropped: used a vertex that is not finite
  std::size_t triangles_degenerate = 0;    ///< dropped: two equal corners, or no area
  std::size_t triangles_duplicate = 0;     ///< dropped: the corners of an earlier one

  /// Whether triangles were dropped or positions replaced.
  bool changed() const {
    return vertices_not_finite + triangles_out_of_range + triangles_not_finite +
               triangles_degenerate + triangles_duplicate >
           0;
  }

  bool operator==(const MeshRepair&) const = default;
};

/// One line per finding, for reports to the user; empty if there are none.
std::string describe(const MeshRepair& repair);

/// Drops unusable triangles. Vertices stay and keep their numbers, so that data per vertex still
/// match; those that are not finite move to the centroid of the others.
MeshRepair repair_mesh(Mesh& mesh);

/// As above; `kept` receives the previous numbers of the remaining triangles.
MeshRepair repair_mesh(Mesh& mesh, std::vector<Index>& kept);

/// A mesh from another program's arrays, with the sources of its vertices and triangles.
struct RepairedMesh {
  Mesh mesh;
  MeshRepair repair;
  /// For every vertex, the one that triangles use in its place: itself, or the first at the same
  /// position. Empty if nothing was joined.
  std::vector<Index> vertex_of_row;
  /// The previous numbers of the remaining triangles. Empty if all remain.
  std::vector<Index> kept_triangles;
};

/// As `make_mesh`, with the repairs of `read_mesh`. Triangles use the first of all vertices at
/// exactly one position, which closes meshes split along sharp edges or texture seams. Unusable
/// triangles are dropped (`MeshRepair`). Vertices keep their numbers. Throws Error for arrays
/// without three columns, and for corners that are not whole numbers.
RepairedMesh make_repaired_mesh(const ArrayView& positions, const ArrayView& triangles);

/// Moves positions with a coordinate that is NaN, infinite or beyond 1e18 to the centroid of the
/// others. Returns 1 for every position that was valid, otherwise 0.
std::vector<char> set_positions_finite(std::vector<Vec3>& positions);

/// Makes triangles use, of all vertices at exactly the same position, the one with the smallest
/// number. The others stay, unreferenced. Returns their number.
std::size_t join_vertices(Mesh& mesh);

/// For every position, the first that is exactly equal; itself if it is invalid. Throws Cancelled
/// if `progress` cancels.
std::vector<Index> first_at_each_place(std::span<const Vec3> positions,
                                       const Progress& progress = {});

/// As above, with the result of `first_at_each_place`.
std::size_t join_vertices(Mesh& mesh, std::span<const Index> first);

/// Removes vertices that no triangle uses and renumbers the others in order. Returns new numbers,
/// indexed by the old ones; entries of removed vertices have no meaning.
std::vector<Index> drop_unreferenced_vertices(Mesh& mesh);

/// Appends all vertices and triangles of `other` to `mesh`, whose origin stays unless it is empty.
void append(const Mesh& other, Mesh& mesh);

/// Adds `way` to all positions; the origin stays.
void translate(Mesh& mesh, const Vec3& way);

/// Splits every triangle in four at the midpoints of its edges, `times` times. Triangles that share
/// an edge, however many, share its midpoint. Old vertices keep their numbers; the midpoints
/// follow, ordered by the numbers of their edge's ends. The triangles of triangle t are 4 t .. 4 t
/// + 3, the inner one last. Throws Error if `times` is negative, or for more triangles than an
/// Index can count; Cancelled if `progress` cancels.
Mesh subdivide(Mesh mesh, int times = 1, const Progress& progress = {});

/// Positions of edge midpoints: straight between the ends, or on a curve at right angles to the
/// surface's normals there (the edges of curved point-normal triangles, Vlachos et al. 2001), which
/// rounds coarse meshes. Old vertices stay. Edges stay straight where the surface bends by more
/// than 40 degrees, and where three or more triangles meet.
enum class Midpoints { straight, rounded };
Mesh subdivide(Mesh mesh, int times, Midpoints midpoints, const Progress& progress = {});

/// Appends the triangles of a polygon, wound as it is, to `triangles`: n - 2 for n corners, none
/// for fewer than 3. Polygons may be concave and touch themselves, as where a bridge of two equal
/// edges leads to a hole. Quadrangles are cut along their shorter inner diagonal. Others are cut by
/// ear clipping in the plane of the mean normal; more than 1000 corners form a fan if it covers
/// them. All of Brindle cuts polygons this way. `corners` are numbers of `positions`. Returns
/// whether the triangles cover the polygon's area by Newell's formula; they cover more where it
/// crosses itself.
bool triangulate_polygon(std::span<const Vec3> positions, std::span<const Index> corners,
                         std::vector<Triangle>& triangles);

/// Polygons for which `triangulate_polygon` returned false.
struct CrossedPolygons {
  std::size_t count = 0;
  std::size_t first = 0;  ///< number of the first one

  void add(std::size_t polygon) {
    if (count++ == 0) first = polygon;
  }
};

/// A line for the user; empty if there are none.
std::string describe(const CrossedPolygons& polygons);

}  // namespace brindle
