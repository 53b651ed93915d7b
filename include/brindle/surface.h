/// A mesh with what every job derives from it once per connectivity.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/adjacency.h"
#include "brindle/export.h"
#include "brindle/mesh.h"

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
/// them.
Surface make_surface(Mesh mesh);

/// Throws Error, naming the first vertex, for a position that is not finite.
void check_positions(std::span<const Vec3> positions);

/// The same, and naming the first triangle, for a corner that is no vertex of the mesh.
void check_mesh(const Mesh& mesh);

}  // namespace brindle
