/// A mesh with its neighbourhood and normals, derived once, and the closed ways along its edges.
#pragma once

#include <cstddef>
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
  /// Which vertices are copies of others, along creases (`split_at_creases`).
  Creases creases = {};
  /// The neighbourhood with the links over creases; null where there are none.
  std::shared_ptr<const Adjacency> linked = {};

  /// How many vertices there were before creases split any.
  std::size_t own_vertex_count() const { return mesh.vertex_count() - creases.copied.size(); }

  /// Whose waves are coupled: neighbours, and vertices on the two sides of a crease.
  const std::shared_ptr<const Adjacency>& coupled() const { return linked ? linked : neighborhood; }
};

/// Derives neighbourhood and normals. Takes the mesh over. Throws Error, naming the first vertex or
/// triangle, for a position that is not finite and a corner that is no vertex of the mesh.
/// Triangles with two corners alike have no area, and no edge from a vertex to itself comes of
/// them. Throws Error, too, if edges are shorter than 1e-10 or longer than 1e9 on average: squares
/// of areas would leave the range of float, and other units are needed. Throws Cancelled if
/// `progress` asks for it.
Surface make_surface(Mesh mesh, const Progress& progress = {});

/// The same of a mesh that `split_at_creases` has split: waves on the two sides of a crease are
/// coupled, and surface_warnings knows that copies stand at one place.
Surface make_surface(Mesh mesh, Creases creases, const Progress& progress = {});

/// Likely mistakes, one sentence each without a full stop: boundary edges at exactly the same place
/// as others, where the surface is cut and stripes end. `join` tells how to join vertices.
std::vector<std::string> surface_warnings(
    const Surface& surface, const std::string& join = "join them with make_repaired_mesh");

/// Throws Error, naming the first vertex, for a position that is not finite.
void check_positions(std::span<const Vec3> positions);

/// The same, and naming the first triangle, for a corner that is no vertex of the mesh.
void check_mesh(const Mesh& mesh);

/// A closed way along edges: a boundary, or a way round a handle.
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
/// they generate all closed ways on the surface. Loops of handles are the shortest of those that a
/// tree of shortest ways from one vertex of each piece allows (Erickson and Whittlesey 2005). A
/// piece with an edge of three triangles or more has none; nor have points without triangles.
std::vector<SurfaceLoop> surface_loops(const Surface& surface);

}  // namespace brindle
