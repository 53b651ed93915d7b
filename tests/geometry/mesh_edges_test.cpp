#include "brindle/geometry/topology.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "brindle/geometry/topology.h"
#include "test_meshes.h"

namespace brindle {
namespace {

TEST(MeshEdges, NumberEveryEdgeOnce) {
  for (const auto& [name, mesh] : every_shape()) {
    SCOPED_TRACE(name);
    const Adjacency neighborhood = vertex_neighborhood(mesh);
    const MeshEdges edges = mesh_edges(mesh, neighborhood);
    ASSERT_EQ(edges.count(), neighborhood.edge_count());
    std::vector<Index> counts(edges.count());
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      for (int m = 0; m < 3; ++m) {
        const Index a = mesh.triangles[t][m], b = mesh.triangles[t][(m + 1) % 3];
        const Index edge = edges.of_triangle[t][m];
        ASSERT_EQ(edges.vertices[edge], (std::array{std::min(a, b), std::max(a, b)}));
        ASSERT_EQ(edges.ranks[t][m], counts[edge]++);
      }
    }
    EXPECT_EQ(edges.triangle_counts, counts);
  }
}

}  // namespace
}  // namespace brindle
