#include "brindle/geometry/mesh_edges.h"

#include <algorithm>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

/// For every vertex the number of its first edge to a lower vertex; one entry more at the end.
std::vector<Index> first_edges(const Adjacency& neighborhood) {
  std::vector<Index> first(neighborhood.node_count() + 1, 0);
  for (Index v = 0; v < neighborhood.node_count(); ++v) {
    const auto row = neighborhood.of(v);
    const auto lower = std::lower_bound(row.begin(), row.end(), v) - row.begin();
    first[v + 1] = first[v] + static_cast<Index>(lower);
  }
  return first;
}

}  // namespace

MeshEdges mesh_edges(const Mesh& mesh, const Adjacency& neighborhood) {
  const std::vector<Index> first = first_edges(neighborhood);
  MeshEdges edges;
  edges.vertices.resize(first.back());
  for (Index v = 0; v < neighborhood.node_count(); ++v) {
    for (Index e = first[v]; e < first[v + 1]; ++e) {
      edges.vertices[e] = {neighborhood.of(v)[e - first[v]], v};
    }
  }
  edges.of_triangle.resize(mesh.triangle_count());
  parallel_for(mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (int m = 0; m < 3; ++m) {
        const auto [low, high] = std::minmax(mesh.triangles[t][m], mesh.triangles[t][(m + 1) % 3]);
        const auto row = neighborhood.of(high);
        const auto place = std::lower_bound(row.begin(), row.end(), low) - row.begin();
        edges.of_triangle[t][m] = first[high] + static_cast<Index>(place);
      }
    }
  });
  edges.triangle_counts.assign(edges.count(), 0);
  edges.ranks.resize(mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (int m = 0; m < 3; ++m) {
      edges.ranks[t][m] = edges.triangle_counts[edges.of_triangle[t][m]]++;
    }
  }
  return edges;
}

std::vector<std::array<Index, 2>> triangles_of_edges(const MeshEdges& edges) {
  std::vector<std::array<Index, 2>> result(edges.count(), {kNoTriangle, kNoTriangle});
  for (Index t = 0; t < edges.of_triangle.size(); ++t) {
    for (int m = 0; m < 3; ++m) {
      const Index rank = edges.ranks[t][m];
      if (rank < 2) result[edges.of_triangle[t][m]][rank] = t;
    }
  }
  return result;
}

}  // namespace brindle
