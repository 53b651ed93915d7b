#include "brindle/geometry/topology.h"

#include <algorithm>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

/// For every vertex the number of its first edge to a lower vertex; one entry more at the end.
std::vector<Index> first_edges(const Adjacency& neighborhood, const Progress& progress) {
  std::vector<Index> first(neighborhood.node_count() + 1, 0);
  reported_for(neighborhood.node_count(), progress, [&](std::size_t i) {
    const auto v = static_cast<Index>(i);
    const auto row = neighborhood.of(v);
    const auto lower = std::lower_bound(row.begin(), row.end(), v) - row.begin();
    first[v + 1] = first[v] + static_cast<Index>(lower);
  });
  return first;
}

}  // namespace

MeshEdges mesh_edges(const Mesh& mesh, const Adjacency& neighborhood, const Progress& progress) {
  const std::vector<Index> first = first_edges(neighborhood, progress.part(0, 0.1));
  MeshEdges edges;
  edges.vertices.resize(first.back());
  reported_for(neighborhood.node_count(), progress.part(0.1, 0.3), [&](std::size_t i) {
    const auto v = static_cast<Index>(i);
    for (Index e = first[v]; e < first[v + 1]; ++e) {
      edges.vertices[e] = {neighborhood.of(v)[e - first[v]], v};
    }
  });
  edges.of_triangle.resize(mesh.triangle_count());
  parallel_for(mesh.triangle_count(), progress.part(0.3, 0.8),
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t t = begin; t < end; ++t) {
                   for (int m = 0; m < 3; ++m) {
                     const auto [low, high] =
                         std::minmax(mesh.triangles[t][m], mesh.triangles[t][(m + 1) % 3]);
                     const auto row = neighborhood.of(high);
                     const auto place = std::lower_bound(row.begin(), row.end(), low) - row.begin();
                     edges.of_triangle[t][m] = first[high] + static_cast<Index>(place);
                   }
                 }
               });
  edges.triangle_counts.assign(edges.count(), 0);
  edges.ranks.resize(mesh.triangle_count());
  reported_for(mesh.triangle_count(), progress.part(0.8, 1), [&](std::size_t t) {
    for (int m = 0; m < 3; ++m) {
      edges.ranks[t][m] = edges.triangle_counts[edges.of_triangle[t][m]]++;
    }
  });
  return edges;
}

std::vector<std::array<Index, 2>> triangles_of_edges(const MeshEdges& edges,
                                                     const Progress& progress) {
  std::vector<std::array<Index, 2>> result(edges.count(), {kNoTriangle, kNoTriangle});
  reported_for(edges.of_triangle.size(), progress, [&](std::size_t t) {
    for (int m = 0; m < 3; ++m) {
      const Index rank = edges.ranks[t][m];
      if (rank < 2) result[edges.of_triangle[t][m]][rank] = static_cast<Index>(t);
    }
  });
  return result;
}

}  // namespace brindle
