#include "brindle/relief/relief_bodies.h"

#include <numeric>

#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

/// Numbered items that are joined into sets.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  Index first(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) {
    a = first(a);
    b = first(b);
    parent_[a < b ? b : a] = a < b ? a : b;
  }

 private:
  std::vector<Index> parent_;
};

/// The corners of one vertex that triangles with common edges connect, as sets of corners.
JoinedSets joined_corners(const Mesh& part, const std::vector<Index>& twins) {
  JoinedSets corners(3 * part.triangle_count());
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] == kNoTwin) continue;
    corners.join(h, next_in_triangle(twins[h]));
    corners.join(next_in_triangle(h), twins[h]);
  }
  return corners;
}

}  // namespace

ReliefBodies relief_bodies(const Mesh& surface, const std::vector<std::uint8_t>& taken) {
  Mesh part{surface.positions, {}, surface.origin};
  for (std::size_t t = 0; t < taken.size(); ++t) {
    if (taken[t] != 0) part.triangles.push_back(surface.triangles[t]);
  }
  const std::vector<Index> twins = twins_of(part.triangles);
  JoinedSets corners = joined_corners(part, twins);
  ReliefBodies bodies;
  bodies.mesh.origin = surface.origin;
  std::vector<Index> numbers(3 * part.triangle_count());
  for (Index c = 0; c < numbers.size(); ++c) {
    if (corners.first(c) != c) {
      numbers[c] = numbers[corners.first(c)];
      continue;
    }
    const Index vertex = vertex_at(part.triangles, c);
    numbers[c] = static_cast<Index>(bodies.vertices.size());
    for (const bool below : {false, true}) {
      bodies.vertices.push_back(vertex);
      bodies.below.push_back(below ? 1 : 0);
      bodies.mesh.positions.push_back(surface.positions[vertex]);
    }
  }
  for (Index t = 0; t < part.triangle_count(); ++t) {
    const Index a = numbers[3 * t], b = numbers[3 * t + 1], c = numbers[3 * t + 2];
    bodies.mesh.triangles.push_back({a, b, c});
    bodies.mesh.triangles.push_back({a + 1, c + 1, b + 1});
  }
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] != kNoTwin) continue;
    const Index a = numbers[h], b = numbers[next_in_triangle(h)];
    bodies.mesh.triangles.push_back({b, a, a + 1});
    bodies.mesh.triangles.push_back({b, a + 1, b + 1});
  }
  return bodies;
}

std::size_t component_count(const Mesh& mesh) {
  JoinedSets vertices(mesh.vertex_count());
  std::vector<std::uint8_t> used(mesh.vertex_count());
  for (const Triangle& t : mesh.triangles) {
    vertices.join(t[0], t[1]);
    vertices.join(t[0], t[2]);
    for (const Index v : t) used[v] = 1;
  }
  std::size_t count = 0;
  for (Index v = 0; v < used.size(); ++v) count += used[v] != 0 && vertices.first(v) == v ? 1 : 0;
  return count;
}

}  // namespace brindle
