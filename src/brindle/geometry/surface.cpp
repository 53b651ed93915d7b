#include "brindle/geometry/surface.h"

#include <utility>

#include "brindle/geometry/neighborhood.h"
#include "brindle/geometry/normals.h"

namespace brindle {

Surface make_surface(Mesh mesh) {
  Surface surface;
  surface.neighborhood = std::make_shared<const Adjacency>(vertex_neighborhood(mesh));
  surface.normals = vertex_normals(mesh);
  surface.mesh = std::move(mesh);
  return surface;
}

}  // namespace brindle
