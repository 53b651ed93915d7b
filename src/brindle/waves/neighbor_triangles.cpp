#include "brindle/waves/neighbor_triangles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

constexpr float kLargestAngle = 2 * std::numbers::pi_v<float> / 3;
constexpr float kSmallestAngle = 0.02f;

/// The neighbours of `i` by their angle about its normal, counter-clockwise.
std::vector<std::pair<float, Index>> around(std::span<const Vec3> positions, const Vec3& normal,
                                            const Adjacency& neighborhood, Index i) {
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  std::vector<std::pair<float, Index>> result;
  for (const Index j : neighborhood.of(i)) {
    const Vec3 edge = positions[j] - positions[i];
    result.emplace_back(elementary::atan2(edge.dot(y), edge.dot(x)), j);
  }
  ranges::sort(result.begin(), result.end());
  return result;
}

/// The same three numbers whoever names them first.
Triangle from_smallest(Index a, Index b, Index c) {
  Triangle triangle = {a, b, c};
  ranges::sort(triangle.begin(), triangle.end());
  return triangle;
}

}  // namespace

std::vector<Triangle> neighbor_triangles(std::span<const Vec3> positions,
                                         std::span<const Vec3> normals,
                                         const Adjacency& neighborhood, const Progress& progress) {
  std::vector<Triangle> triangles;
  reported_for(neighborhood.node_count(), progress.part(0, 0.5), [&](std::size_t point) {
    const auto i = static_cast<Index>(point);
    if (normals[i].isZero(0)) return;
    const auto ring = around(positions, normals[i], neighborhood, i);
    for (std::size_t k = 0; k < ring.size() && ring.size() > 1; ++k) {
      const bool last = k + 1 == ring.size();
      const auto& [next_angle, next] = ring[last ? 0 : k + 1];
      const float angle =
          next_angle - ring[k].first + (last ? 2 * std::numbers::pi_v<float> : 0.0f);
      if (angle < kSmallestAngle || angle > kLargestAngle) continue;
      triangles.push_back(from_smallest(i, ring[k].second, next));
    }
  });
  ticking_sort(triangles.begin(), triangles.end(), progress.part(0.5, 1), std::less<>());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

}  // namespace brindle
