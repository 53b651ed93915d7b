#include "brindle/geometry/measures.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

constexpr float kLargestCotangent = 10;

/// Cotangent of the angle at `apex` between the directions to a and b; zero without an area.
float cotangent(const Vec3& apex, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - apex, v = b - apex;
  const float sine = u.cross(v).norm();
  return sine > 0 ? u.dot(v) / sine : 0;
}

/// Half the cotangents of a mesh's angles: three a triangle.
std::vector<float> half_cotangents(const Mesh& mesh, const Progress& progress) {
  std::vector<float> halves(3 * mesh.triangle_count());
  parallel_for(mesh.triangle_count(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Triangle& corners = mesh.triangles[t];
      for (int m = 0; m < 3; ++m) {
        halves[3 * t + m] =
            0.5f * cotangent(mesh.positions[corners[m]], mesh.positions[corners[(m + 1) % 3]],
                             mesh.positions[corners[(m + 2) % 3]]);
      }
    }
  });
  return halves;
}

}  // namespace

std::vector<float> edge_cotangents(const Mesh& mesh, const Adjacency& neighborhood,
                                   const Progress& progress) {
  const std::vector<float> halves = half_cotangents(mesh, progress.part(0, 0.4));
  const VertexTriangles around = vertex_triangles(mesh, progress.part(0.4, 0.6));
  std::vector<float> sums(neighborhood.directed_edge_count());
  const auto add_to_row = [&](Index vertex, std::size_t triangle) {
    const Triangle& corners = mesh.triangles[triangle];
    const auto row = neighborhood.of(vertex);
    for (int m = 0; m < 3; ++m) {
      if (corners[m] == vertex) continue;
      // The angle opposite the edge is at the third corner.
      const int opposite = corners[(m + 1) % 3] == vertex ? (m + 2) % 3 : (m + 1) % 3;
      const auto place = ranges::lower_bound(row, corners[m]);
      if (place == row.end() || *place != corners[m]) continue;
      sums[neighborhood.offsets[vertex] + static_cast<std::size_t>(place - row.begin())] +=
          halves[3 * triangle + opposite];
    }
  };
  parallel_for(
      neighborhood.node_count(), progress.part(0.6, 1), [&](std::size_t begin, std::size_t end) {
        for (Index v = static_cast<Index>(begin); v < end; ++v) {
          for (const Index t : around.of(v)) add_to_row(v, t);
          const auto first = sums.begin() + neighborhood.offsets[v];
          const auto last = sums.begin() + neighborhood.offsets[v + 1];
          std::transform(first, last, first,
                         [](float sum) { return std::clamp(sum, 0.0f, kLargestCotangent); });
        }
      });
  return sums;
}

std::vector<float> cotangent_weights(const Mesh& mesh, const Adjacency& neighborhood,
                                     const Progress& progress) {
  std::vector<float> weights = edge_cotangents(mesh, neighborhood, progress);
  for (float& weight : weights) weight += 0.5f;
  return weights;
}

}  // namespace brindle
