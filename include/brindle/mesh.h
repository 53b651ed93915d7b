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

/// A triangle mesh. Its topology may be any: open, non-manifold, unorientable, or in pieces, and
/// may have vertices that no triangle uses. Positions are finite and triangle corners in range and
/// different from each other; `repair_mesh` sees to that.
struct Mesh {
  std::vector<Vec3> positions;  ///< relative to `origin`
  std::vector<Triangle> triangles;
  /// Where the positions' zero stands. Floats lose the shape of what is small and far from zero, so
  /// files with such coordinates are read relative to a point nearby and written back in place.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();

  std::size_t vertex_count() const { return positions.size(); }
  std::size_t triangle_count() const { return triangles.size(); }
};

/// Corners of the axis-aligned box around all vertices that a triangle uses, or around all vertices
/// if there is no triangle; both zero if there is no vertex.
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
  kept  ///< for `repair_mesh`, or where no pattern is made
};

/// A mesh from another program's arrays: three coordinates per vertex, three vertex numbers from 0
/// per triangle, signed or not. Vertices and triangles keep their numbers. Coordinates that are
/// large against the mesh's size are made relative to `Mesh::origin`. Throws Error, naming the
/// first vertex or triangle and the remedy, for coordinates that are not finite or beyond 1e18,
/// corners that are no vertices, triangles with two corners alike or with the corners of an earlier
/// one, and arrays that have not three columns or no whole numbers where these are asked for.
/// Vertices at one place stay apart, and so do the triangles on both sides: `surface_warnings`
/// tells, `make_repaired_mesh` joins them. Throws Cancelled if `progress` asks for it.
Mesh make_mesh(const ArrayView& positions, const ArrayView& triangles,
               BadTriangles bad = BadTriangles::refused, const Progress& progress = {});

/// Defects of a mesh. All are repaired, except `vertices_unreferenced`.
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

/// As above; `kept` receives the previous number of every remaining triangle.
MeshRepair repair_mesh(Mesh& mesh, std::vector<Index>& kept);

/// A mesh from another program's arrays, with the rows that its vertices and triangles come from.
struct RepairedMesh {
  Mesh mesh;
  MeshRepair repair;
  /// For every vertex the one that triangles use in its place: itself, or the first at the same
  /// place. Empty if nothing was joined.
  std::vector<Index> vertex_of_row;
  /// The previous number of every remaining triangle. Empty if all remain.
  std::vector<Index> kept_triangles;
};

/// As `make_mesh`, with what `read_mesh` does to a file's mesh: triangles use the first of all
/// vertices that stand at exactly one place, so that meshes split along sharp edges or seams of
/// texture are whole; and triangles that cannot be used are dropped (`MeshRepair`). Vertices keep
/// their numbers. Throws Error for arrays that have not three columns or no whole numbers where
/// these are asked for.
RepairedMesh make_repaired_mesh(const ArrayView& positions, const ArrayView& triangles);

/// Moves positions with a coordinate that is NaN, infinite or beyond 1e18 to the centroid of the
/// others. Returns, for every position, whether it was good.
std::vector<char> set_positions_finite(std::vector<Vec3>& positions);

/// Lets triangles use, of all vertices at exactly the same place, the one with the smallest number.
/// The others stay, in no triangle. Returns how many there are.
std::size_t join_vertices(Mesh& mesh);

/// For every position the first that is exactly the same; itself for one that is no good. Throws
/// Cancelled if `progress` asks for it.
std::vector<Index> first_at_each_place(std::span<const Vec3> positions,
                                       const Progress& progress = {});

/// As above, with the result of `first_at_each_place`.
std::size_t join_vertices(Mesh& mesh, std::span<const Index> first);

/// Removes vertices that no triangle uses; the others are renumbered in order. Returns the new
/// number of every remaining vertex.
std::vector<Index> drop_unreferenced_vertices(Mesh& mesh);

/// Adds all vertices and triangles of `other` behind those of `mesh`, whose origin stays unless it
/// is empty.
void append(const Mesh& other, Mesh& mesh);

/// Adds `way` to all positions; the origin stays.
void translate(Mesh& mesh, const Vec3& way);

/// Splits every triangle in four at the midpoints of its edges, `times` times. Triangles that share
/// an edge, however many, share its midpoint. Old vertices keep their numbers; the midpoints
/// follow, ordered by the numbers of their edge's ends. The triangles of triangle t are 4 t .. 4 t
/// + 3, the inner one last. Throws Error if `times` is negative, or the result would have more
/// triangles than brindle can number. Throws Cancelled if `progress` asks for it.
Mesh subdivide(Mesh mesh, int times = 1, const Progress& progress = {});

/// Where the midpoints of edges lie: straight between their ends, or on a curve at right angles to
/// the surface's normals there (the edges of curved point-normal triangles, Vlachos et al. 2001),
/// so that a coarse mesh of something round becomes round. Old vertices stay. Edges stay straight
/// where the surface bends by more than 40 degrees, and where three triangles or more meet.
enum class Midpoints { straight, rounded };
Mesh subdivide(Mesh mesh, int times, Midpoints midpoints, const Progress& progress = {});

/// Appends the triangles of a polygon, wound as it is, to `triangles`: n - 2 for n corners, none
/// for fewer than 3. Polygons may be concave and touch themselves, as those do that reach a hole by
/// a bridge of two equal edges. Quadrangles are cut along their shorter inner diagonal, others by
/// ear clipping in the plane of the polygon's mean normal, those of more than 1000 corners into a
/// fan if that covers them. All of Brindle cuts polygons so. `corners` are numbers of `positions`.
/// Returns whether the triangles cover the area that the polygon encloses by Newell's formula. They
/// cover more where it crosses itself.
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
