#include "brindle/geometry/cotangent_weights.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

constexpr float kLargestCotangent = 10;

/// To the edge between them in the row of `to`, if that has it.
void add_to_edge(const Adjacency& neighborhood, Index from, Index to, float more,
                 std::vector<float>& weights) {
  const auto row = neighborhood.of(to);
  const auto place = std::lower_bound(row.begin(), row.end(), from);
  if (place == row.end() || *place != from) return;
  weights[neighborhood.offsets[to] + static_cast<std::size_t>(place - row.begin())] += more;
}

/// Cotangent of the angle at `apex` between the directions to a and b; zero without an area.
float cotangent(const Vec3& apex, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - apex, v = b - apex;
  const float sine = u.cross(v).norm();
  return sine > 0 ? u.dot(v) / sine : 0;
}

}  // namespace

std::vector<float> cotangent_weights(const Mesh& mesh, const Adjacency& neighborhood,
                                     const Progress& progress) {
  std::vector<float> weights(neighborhood.directed_edge_count());
  reported_for(mesh.triangle_count(), progress, [&](std::size_t t) {
    const Triangle& triangle = mesh.triangles[t];
    for (int m = 0; m < 3; ++m) {
      const Index a = triangle[(m + 1) % 3], b = triangle[(m + 2) % 3];
      const float half =
          0.5f * cotangent(mesh.positions[triangle[m]], mesh.positions[a], mesh.positions[b]);
      add_to_edge(neighborhood, a, b, half, weights);
      add_to_edge(neighborhood, b, a, half, weights);
    }
  });
  parallel_for(weights.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t edge = begin; edge < end; ++edge) {
      weights[edge] = 0.5f + std::clamp(weights[edge], 0.0f, kLargestCotangent);
    }
  });
  return weights;
}

}  // namespace brindle
