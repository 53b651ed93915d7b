#include "brindle/relief/relief_bodies.h"

#include <array>

#include <Eigen/Geometry>

#include "brindle/base/graph.h"
#include "brindle/base/parallel.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

/// The corners of one vertex that triangles with common edges connect, as sets of corners.
MergedSets joined_corners(const std::vector<Index>& twins) {
  MergedSets corners(twins.size());
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] == kNoTwin) continue;
    corners.merge(h, next_in_triangle(twins[h]));
    corners.merge(next_in_triangle(h), twins[h]);
  }
  return corners;
}

}  // namespace

ReliefBodies relief_bodies(const std::vector<Triangle>& surface,
                           const std::vector<std::uint8_t>& taken) {
  std::vector<Triangle> part;
  for (std::size_t t = 0; t < taken.size(); ++t) {
    if (taken[t] != 0) part.push_back(surface[t]);
  }
  const std::vector<Index> twins = twins_of(part);
  MergedSets corners = joined_corners(twins);
  ReliefBodies bodies;
  std::vector<Index> numbers(twins.size());
  for (Index c = 0; c < numbers.size(); ++c) {
    if (corners.of(c) != c) {
      numbers[c] = numbers[corners.of(c)];
      continue;
    }
    numbers[c] = static_cast<Index>(bodies.vertices.size());
    bodies.vertices.insert(bodies.vertices.end(), 2, vertex_at(part, c));
    bodies.below.insert(bodies.below.end(), {0, 1});
  }
  for (Index t = 0; t < part.size(); ++t) {
    const Index a = numbers[3 * t], b = numbers[3 * t + 1], c = numbers[3 * t + 2];
    bodies.triangles.push_back({a, b, c});
    bodies.triangles.push_back({a + 1, c + 1, b + 1});
  }
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] != kNoTwin) continue;
    const Index a = numbers[h], b = numbers[next_in_triangle(h)];
    bodies.triangles.push_back({b, a, a + 1});
    bodies.triangles.push_back({b, a + 1, b + 1});
  }
  return bodies;
}

std::size_t component_count(const Mesh& mesh) {
  MergedSets vertices(mesh.vertex_count());
  std::vector<std::uint8_t> used(mesh.vertex_count());
  for (const Triangle& t : mesh.triangles) {
    vertices.merge(t[0], t[1]);
    vertices.merge(t[0], t[2]);
    for (const Index v : t) used[v] = 1;
  }
  std::size_t count = 0;
  for (Index v = 0; v < used.size(); ++v) count += used[v] != 0 && vertices.of(v) == v ? 1 : 0;
  return count;
}

double volume_of(const Mesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const Vec3 origin = mesh.positions[mesh.triangles[0][0]];
  return parallel_sum<double>(mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t t = begin; t < end; ++t) {
      std::array<Eigen::Vector3d, 3> p;
      for (int m = 0; m < 3; ++m) {
        p[m] = (mesh.positions[mesh.triangles[t][m]] - origin).cast<double>();
      }
      sum += p[0].dot(p[1].cross(p[2])) / 6;
    }
    return sum;
  });
}

}  // namespace brindle
