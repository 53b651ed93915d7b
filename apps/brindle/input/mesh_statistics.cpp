#include "input/mesh_statistics.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"

namespace brindle::tool {
namespace {

// One side of a triangle; in sorted order, the sides of an edge are adjacent.
struct Side {
  Index low;
  Index high;
  Index triangle;
  bool forward;  // runs from low to high

  std::pair<Index, Index> edge() const { return {low, high}; }
};

std::vector<Side> sorted_sides(const Mesh& mesh, const Progress& progress) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangle_count());
  reported_for(mesh.triangle_count(), progress.part(0, 0.2), [&](std::size_t t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Index from = mesh.triangles[t][c];
      const Index to = mesh.triangles[t][(c + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<Index>(t), from < to});
    }
  });
  ticking_sort(sides.begin(), sides.end(), progress,
               [](const Side& a, const Side& b) { return a.edge() < b.edge(); });
  return sides;
}

// Disjoint sets; each element has a parity relative to its root.
class ParitySets {
 public:
  explicit ParitySets(std::size_t count) : parent_(count), parity_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  // Records that the parities of a and b differ by `parity`; false on contradiction.
  bool unite(Index a, Index b, int parity) {
    const auto [root_a, parity_a] = root_of(a);
    const auto [root_b, parity_b] = root_of(b);
    if (root_a == root_b) return (parity_a ^ parity_b) == parity;
    parent_[root_b] = root_a;
    parity_[root_b] = static_cast<std::uint8_t>(parity_a ^ parity_b ^ parity);
    return true;
  }

  bool is_root(Index a) const { return parent_[a] == a; }

 private:
  std::pair<Index, int> root_of(Index a) {
    int parity = 0;
    while (parent_[a] != a) {
      const Index up = parent_[a];
      parity_[a] = static_cast<std::uint8_t>(parity_[a] ^ parity_[up]);
      parent_[a] = parent_[up];
      parity ^= parity_[a];
      a = parent_[a];
    }
    return {a, parity};
  }

  std::vector<Index> parent_;
  std::vector<std::uint8_t> parity_;
};

void count_components(const Mesh& mesh, const Progress& progress, MeshStatistics& statistics) {
  ParitySets sets(mesh.vertex_count());
  std::vector<bool> used(mesh.vertex_count(), false);
  reported_for(mesh.triangle_count(), progress, [&](std::size_t t) {
    const Triangle& triangle = mesh.triangles[t];
    sets.unite(triangle[0], triangle[1], 0);
    sets.unite(triangle[0], triangle[2], 0);
    for (const Index vertex : triangle) used[vertex] = true;
  });
  for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    if (!used[vertex]) ++statistics.unused_vertices;
    if (used[vertex] && sets.is_root(vertex)) ++statistics.components;
  }
}

void count_edges(const Mesh& mesh, const Progress& progress, MeshStatistics& statistics) {
  const std::vector<Side> sides = sorted_sides(mesh, progress.part(0, 0.8));
  Reporter reporter(progress.part(0.8, 1), sides.size());
  ParitySets windings(mesh.triangle_count());
  double length_sum = 0;
  statistics.edge_length_min = std::numeric_limits<double>::max();
  for (auto side = sides.begin(); side != sides.end();) {
    const auto next = std::find_if(side, sides.end(),
                                   [&](const Side& other) { return other.edge() != side->edge(); });
    const auto triangles = next - side;
    ++statistics.edges;
    if (triangles == 1) ++statistics.boundary_edges;
    if (triangles > 2) ++statistics.non_manifold_edges;
    if (triangles == 2) {
      const bool against = side[0].forward == side[1].forward;
      if (against) statistics.wound_alike = false;
      if (!windings.unite(side[0].triangle, side[1].triangle, against ? 1 : 0)) {
        statistics.orientable = false;
      }
    }
    const double length =
        (mesh.positions[side->high] - mesh.positions[side->low]).cast<double>().norm();
    length_sum += length;
    statistics.edge_length_min = std::min(statistics.edge_length_min, length);
    statistics.edge_length_max = std::max(statistics.edge_length_max, length);
    reporter.done(static_cast<std::size_t>(triangles));
    side = next;
  }
  statistics.edge_length_mean = length_sum / static_cast<double>(statistics.edges);
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d origin = mesh.positions[a].cast<double>();
    const Eigen::Vector3d side = mesh.positions[b].cast<double>() - origin;
    sum += side.cross(mesh.positions[c].cast<double>() - origin).norm() / 2;
  }
  return sum;
}

}  // namespace

MeshStatistics mesh_statistics(const Mesh& mesh, const Progress& progress) {
  MeshStatistics statistics;
  statistics.box = bounding_box(mesh);
  if (mesh.triangles.empty()) return statistics;
  count_components(mesh, progress.part(0, 0.2), statistics);
  count_edges(mesh, progress.part(0.2, 0.9), statistics);
  statistics.area = area(mesh);
  progress.report(1);
  return statistics;
}

PointStatistics point_statistics(const PointCloud& cloud, const Adjacency& neighborhood) {
  PointStatistics statistics;
  statistics.used = cloud.used.size();
  if (cloud.used.empty()) return statistics;
  statistics.edges = neighborhood.edge_count();
  statistics.neighbors_mean =
      2 * static_cast<double>(statistics.edges) / static_cast<double>(statistics.used);
  statistics.box.lower = statistics.box.upper = cloud.positions[cloud.used[0]];
  statistics.spacing_min = std::numeric_limits<double>::max();
  ParitySets sets(cloud.positions.size());
  std::size_t measured = 0;
  for (const Index i : cloud.used) {
    statistics.box.lower = statistics.box.lower.cwiseMin(cloud.positions[i]);
    statistics.box.upper = statistics.box.upper.cwiseMax(cloud.positions[i]);
    double nearest = std::numeric_limits<double>::max();
    for (const Index j : neighborhood.of(i)) {
      sets.unite(i, j, 0);
      nearest = std::min(nearest, (cloud.positions[i] - cloud.positions[j]).cast<double>().norm());
    }
    if (neighborhood.of(i).empty()) continue;
    ++measured;
    statistics.spacing_mean += nearest;
    statistics.spacing_min = std::min(statistics.spacing_min, nearest);
    statistics.spacing_max = std::max(statistics.spacing_max, nearest);
  }
  if (measured == 0) statistics.spacing_min = 0;
  statistics.spacing_mean /= static_cast<double>(std::max<std::size_t>(measured, 1));
  for (const Index i : cloud.used) statistics.components += sets.is_root(i);
  return statistics;
}

}  // namespace brindle::tool
