#include "brindle/geometry/vertex_triangles.h"

#include <limits>
#include <string>

#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {

VertexTriangles vertex_triangles(const Mesh& mesh, const Progress& progress) {
  // A neighbourhood has up to six entries per triangle, numbered by an Index.
  if (mesh.triangle_count() > std::numeric_limits<Index>::max() / 6) {
    throw Error("the mesh has " + std::to_string(mesh.triangle_count()) +
                " triangles, more than brindle can number; split it into parts");
  }
  VertexTriangles around;
  // Counted one place to the right, so that filling moves each offset to where it belongs.
  around.offsets.assign(mesh.vertex_count() + 2, 0);
  reported_for(mesh.triangle_count(), progress.part(0, 0.3), [&](std::size_t t) {
    for (const Index vertex : mesh.triangles[t]) ++around.offsets[vertex + 2];
  });
  for (std::size_t v = 2; v < around.offsets.size(); ++v) {
    around.offsets[v] += around.offsets[v - 1];
  }
  around.triangles.resize(3 * mesh.triangle_count());
  reported_for(mesh.triangle_count(), progress.part(0.3, 1), [&](std::size_t t) {
    for (const Index vertex : mesh.triangles[t]) {
      around.triangles[around.offsets[vertex + 1]++] = static_cast<Index>(t);
    }
  });
  around.offsets.pop_back();
  return around;
}

}  // namespace brindle
