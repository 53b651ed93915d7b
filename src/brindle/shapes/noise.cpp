#include "brindle/shapes/noise.h"

#include <cmath>

#include "brindle/base/parallel.h"
#include "brindle/base/random.h"
#include "brindle/error.h"
#include "brindle/geometry/normals_around.h"

namespace brindle {
namespace {

double mean_edge_length(const Mesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const double total =
      parallel_sum<double>(mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t t = begin; t < end; ++t) {
          const auto& [a, b, c] = mesh.triangles[t];
          sum += (mesh.positions[b] - mesh.positions[a]).norm();
          sum += (mesh.positions[c] - mesh.positions[b]).norm();
          sum += (mesh.positions[a] - mesh.positions[c]).norm();
        }
        return sum;
      });
  return total / (3.0 * static_cast<double>(mesh.triangle_count()));
}

}  // namespace

void add_noise(Mesh& mesh, float amplitude, std::uint32_t seed, const Progress& progress) {
  if (!std::isfinite(amplitude)) throw Error("the amplitude of noise must be a finite number");
  const VertexTriangles around = vertex_triangles(mesh, progress.part(0, 0.3));
  const std::vector<Vec3> normals = vertex_normals(mesh, around, progress.part(0.3, 0.8));
  progress.report(0.8);
  const double reach = amplitude * mean_edge_length(mesh);
  reported_for(mesh.vertex_count(), progress.part(0.9, 1), [&](std::size_t v) {
    const double distance = reach * (2 * random_number(seed, v) - 1);
    mesh.positions[v] += static_cast<float>(distance) * normals[v];
  });
}

}  // namespace brindle
