/// A mesh with its neighbourhood and normals, computed once, and loops along its edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brindle/creases.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A mesh, its neighbourhood and its vertex normals.
struct Surface {
  Mesh mesh;
  std::shared_ptr<const Adjacency> neighborhood;
  std::vector<Vec3> normals;
  /// Vertices that are copies of others, along creases (`split_at_creases`).
  Creases creases = {};
  /// 1 for triangles whose winding `normals` reverse, as neighbours are wound the other way; empty
  /// if components are wound alike, or cannot be.
  std::vector<std::uint8_t> turned = {};

  /// The number of vertices before creases split any.
  std::size_t own_vertex_count() const { return mesh.vertex_count() - creases.copied.size(); }
  /// The number of edges then.
  std::size_t own_edge_count() const { return neighborhood->edge_count() - creases.edges.size(); }
};

/// Computes neighbourhood and normals. Throws Error, naming the first vertex or triangle, for a
/// position that is not finite and a corner that is no vertex of the mesh. Triangles with two equal
/// corners have no area and add no edge. Throws Error if edges are shorter than 1e-10 or longer
/// than 1e9 on average: squares of areas would leave the range of float, so other units are needed.
/// Throws Cancelled if `progress` cancels.
Surface make_surface(Mesh mesh, const Progress& progress = {});

/// As above for a mesh from `split_at_creases`: stripes are aligned across creases, and
/// surface_warnings ignores coincident copies.
Surface make_surface(Mesh mesh, Creases creases, const Progress& progress = {});

/// Likely mistakes, one sentence each without a full stop: boundary edges that exactly coincide
/// with others, where the surface is cut and stripes end. `join` is the remedy to name.
std::vector<std::string> surface_warnings(
    const Surface& surface, const std::string& join = "join them with make_repaired_mesh");

/// Throws Error, naming the first vertex, for a position that is not finite.
void check_positions(std::span<const Vec3> positions);

/// As above, and naming the first triangle, for a corner that is no vertex of the mesh.
void check_mesh(const Mesh& mesh);

/// A closed path along edges: a boundary, or a loop around a handle. Creases are boundaries of the
/// faces between them.
struct SurfaceLoop {
  /// "boundary-1", "boundary-2" and so on in the order of their lowest vertex numbers; "loop-1" and
  /// so on for handles, the shortest first.
  std::string name;
  bool boundary = false;
  /// In order, the first not repeated. The surface lies to the left of a boundary if triangles are
  /// wound alike.
  std::vector<Index> vertices;
  double length = 0;  ///< in units of length
  /// The mean place along the loop, relative to the mesh's origin, to identify boundaries.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  std::size_t component = 0;  ///< the surface's connected component, from 0
};

/// All boundary loops, of every face between creases, then two loops for every handle (one for
/// every cross-cap); together they generate all closed paths on the surface. Loops of handles are
/// the shortest that a tree of shortest paths from one vertex of each component allows (Erickson
/// and Whittlesey 2005). A component with an edge of three or more triangles has none; nor have
/// points without triangles.
std::vector<SurfaceLoop> surface_loops(const Surface& surface);

}  // namespace brindle
