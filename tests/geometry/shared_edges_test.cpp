#include "brindle/geometry/topology.h"

#include <gtest/gtest.h>

#include "brindle/geometry/topology.h"
#include "test_meshes.h"

namespace brindle {
namespace {

TEST(SharedEdges, LinkTwoTrianglesByTheCornersAtTheSameVertices) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 2, 1}};
  const std::vector<SharedEdge> edges = shared_edges(triangles);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].from, (std::array<Index, 2>{1, 5}));
  EXPECT_EQ(edges[0].to, (std::array<Index, 2>{2, 4}));
}

TEST(SharedEdges, OfThreeTrianglesAreTwo) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_EQ(shared_edges(triangles).size(), 2u);
}

TEST(SharedEdges, AreAllEdgesOfAClosedSurface) {
  for (const char* name : {"torus", "sphere"}) {
    const Mesh& mesh = every_shape().at(name);
    const std::vector<SharedEdge> edges = shared_edges(mesh.triangles);
    EXPECT_EQ(edges.size(), vertex_neighborhood(mesh).edge_count());
    const auto vertex = [&](Index corner) { return mesh.triangles[corner / 3][corner % 3]; };
    for (const SharedEdge& edge : edges) {
      ASSERT_EQ(vertex(edge.from[0]), vertex(edge.from[1]));
      ASSERT_EQ(vertex(edge.to[0]), vertex(edge.to[1]));
      ASSERT_LT(edge.from[0] / 3, edge.from[1] / 3);
    }
  }
}

TEST(SharedEdges, OfNothingAreNone) { EXPECT_TRUE(shared_edges({}).empty()); }

}  // namespace
}  // namespace brindle
