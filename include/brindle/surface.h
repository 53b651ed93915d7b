/// A mesh with what every job derives from it once per connectivity.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brindle/adjacency.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace BRINDLE_EXPORT brindle {

/// A mesh, its neighbourhood and its vertex normals.
struct Surface {
  Mesh mesh;
  std::shared_ptr<const Adjacency> neighborhood;
  std::vector<Vec3> normals;
};

/// Derives neighbourhood and normals. Takes the mesh over. Throws Error, naming the first vertex or
/// triangle, for a position that is not finite and a corner that is no vertex of the mesh.
/// Triangles with two corners alike have no area, and no edge from a vertex to itself comes of
/// them. Throws Error, too, if edges are shorter than 1e-10 or longer than 1e9 on average: squares
/// of areas would leave the range of float, and other units are needed. Throws Cancelled if
/// `progress` asks for it.
Surface make_surface(Mesh mesh, const Progress& progress = {});

/// What is probably not meant, a sentence each without a full stop; `join` says how vertices are
/// joined: edges at the border of the surface that stand exactly where others do, so that the
/// surface is cut there, and stripes end. Empty if there is nothing to say.
std::vector<std::string> surface_warnings(
    const Surface& surface, const std::string& join = "join them with make_repaired_mesh");

/// Throws Error, naming the first vertex, for a position that is not finite.
void check_positions(std::span<const Vec3> positions);

/// The same, and naming the first triangle, for a corner that is no vertex of the mesh.
void check_mesh(const Mesh& mesh);

}  // namespace brindle
