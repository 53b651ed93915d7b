/// A mesh with what every job derives from it once per connectivity.
#pragma once

#include <memory>
#include <vector>

#include "brindle/adjacency.h"
#include "brindle/geometry/mesh.h"

namespace brindle {

/// A mesh, its neighbourhood and its vertex normals.
struct Surface {
  Mesh mesh;
  std::shared_ptr<const Adjacency> neighborhood;
  std::vector<Vec3> normals;
};

/// Derives neighbourhood and normals. Takes the mesh over.
Surface make_surface(Mesh mesh);

}  // namespace brindle
