#include "brindle/geometry/vertex_triangles.h"

#include <limits>
#include <string>

#include "brindle/error.h"

namespace brindle {

VertexTriangles vertex_triangles(const Mesh& mesh) {
  // A neighbourhood has up to six entries per triangle, numbered by an Index.
  if (mesh.triangle_count() > std::numeric_limits<Index>::max() / 6) {
    throw Error("the mesh has " + std::to_string(mesh.triangle_count()) +
                " triangles, more than brindle can number; split it into parts");
  }
  VertexTriangles around;
  // Counted one place to the right, so that filling moves each offset to where it belongs.
  around.offsets.assign(mesh.vertex_count() + 2, 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index vertex : triangle) ++around.offsets[vertex + 2];
  }
  for (std::size_t v = 2; v < around.offsets.size(); ++v) {
    around.offsets[v] += around.offsets[v - 1];
  }
  around.triangles.resize(3 * mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const Index vertex : mesh.triangles[t]) {
      around.triangles[around.offsets[vertex + 1]++] = static_cast<Index>(t);
    }
  }
  around.offsets.pop_back();
  return around;
}

}  // namespace brindle
