#include "brindle/distributed/surface/part_of_whole.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "brindle/geometry/topology.h"

namespace brindle {

std::vector<SentTriangle> sent_triangles(const RankSurface& surface, std::span<const Index> own,
                                         std::span<const Vec3> normals) {
  const std::vector<std::uint64_t> ids = known_ids(surface);
  std::vector<SentTriangle> sent;
  sent.reserve(own.size());
  for (const Index t : own) {
    SentTriangle& triangle = sent.emplace_back();
    triangle.number = surface.triangle_numbers.empty() ? 0 : surface.triangle_numbers[t];
    for (std::size_t c = 0; c < 3; ++c) {
      const Index v = surface.mesh.triangles[t][c];
      triangle.corners[c] = {ids[v], floats_of(surface.mesh.positions[v]), floats_of(normals[v])};
    }
  }
  return sent;
}

PartOfWhole part_of(std::vector<SentTriangle> triangles, const Eigen::Vector3d& origin,
                    std::span<const std::uint64_t> other_ids) {
  std::ranges::stable_sort(triangles, {}, &SentTriangle::number);
  std::vector<SentCorner> corners;
  corners.reserve(3 * triangles.size());
  for (const SentTriangle& triangle : triangles) {
    corners.insert(corners.end(), triangle.corners.begin(), triangle.corners.end());
  }
  for (const std::uint64_t id : other_ids) corners.push_back({id, {}, {}});
  std::ranges::stable_sort(corners, {}, &SentCorner::id);
  const auto same = [](const SentCorner& a, const SentCorner& b) { return a.id == b.id; };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  PartOfWhole part;
  part.surface.mesh.origin = origin;
  for (const SentCorner& corner : corners) {
    part.ids.push_back(corner.id);
    part.surface.mesh.positions.push_back(vector_of(corner.position));
    part.surface.normals.push_back(vector_of(corner.normal));
  }
  for (const SentTriangle& triangle : triangles) {
    Triangle& own = part.surface.mesh.triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const auto place = std::ranges::lower_bound(part.ids, triangle.corners[c].id);
      own[c] = static_cast<Index>(place - part.ids.begin());
    }
  }
  part.surface.neighborhood =
      std::make_shared<const Adjacency>(vertex_neighborhood(part.surface.mesh));
  return part;
}

}  // namespace brindle
