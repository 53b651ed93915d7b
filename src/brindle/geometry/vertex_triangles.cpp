#include "brindle/geometry/topology.h"

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
  const auto add_all = [&](const Progress& part, const auto& add) {
    reported_for(mesh.triangle_count(), part, [&](std::size_t t) {
      for (const Index vertex : mesh.triangles[t]) add(vertex, static_cast<Index>(t));
    });
  };
  return compressed_rows<Index>(mesh.vertex_count(), progress, add_all);
}

}  // namespace brindle
