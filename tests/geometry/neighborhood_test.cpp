#include "brindle/geometry/topology.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/shapes.h"
#include "test_meshes.h"

namespace brindle {
namespace {

std::vector<Index> row(const Adjacency& neighborhood, Index v) {
  const auto neighbors = neighborhood.of(v);
  return {neighbors.begin(), neighbors.end()};
}

TEST(Neighborhood, OfOneTriangleIsTheOtherCorners) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const Adjacency neighborhood = vertex_neighborhood(mesh);
  EXPECT_EQ(row(neighborhood, 0), (std::vector<Index>{1, 2}));
  EXPECT_EQ(row(neighborhood, 1), (std::vector<Index>{0, 2}));
  EXPECT_EQ(row(neighborhood, 2), (std::vector<Index>{0, 1}));
}

TEST(Neighborhood, UnusedVerticesHaveNone) {
  const Mesh mesh{{{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 2, 3}}};
  const Adjacency neighborhood = vertex_neighborhood(mesh);
  EXPECT_EQ(neighborhood.node_count(), 5u);
  EXPECT_TRUE(neighborhood.of(1).empty());
  EXPECT_TRUE(neighborhood.of(4).empty());
}

TEST(Neighborhood, CountsAnEdgeOfManyTrianglesOnce) {
  const Mesh mesh{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                  {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  EXPECT_EQ(row(vertex_neighborhood(mesh), 0), (std::vector<Index>{1, 2, 3, 4}));
}

TEST(Neighborhood, OfAnEmptyMeshIsEmpty) { EXPECT_EQ(vertex_neighborhood({}).node_count(), 0u); }

TEST(Neighborhood, IsSymmetricSortedAndMatchesTheEdgesOfEveryShape) {
  for (const auto& [name, mesh] : every_shape()) {
    using Edges = std::vector<std::pair<Index, Index>>;
    Edges edges;
    for (const Triangle& t : mesh.triangles) {
      for (int c = 0; c < 3; ++c) {
        edges.emplace_back(t[c], t[(c + 1) % 3]);
        edges.emplace_back(t[(c + 1) % 3], t[c]);
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const Adjacency neighborhood = vertex_neighborhood(mesh);
    Edges found;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      for (const Index n : neighborhood.of(v)) found.emplace_back(v, n);
    }
    // Equal only if every row is sorted and holds no vertex twice.
    EXPECT_TRUE(found == edges) << name;
  }
}

TEST(Neighborhood, IsTheSameWithOneThreadAndMany) {
  const Mesh mesh = make_shape("torus");
  const Adjacency many = vertex_neighborhood(mesh);
  const ThreadLimit limit(1);
  const Adjacency one = vertex_neighborhood(mesh);
  EXPECT_EQ(one.offsets, many.offsets);
  EXPECT_EQ(one.neighbors, many.neighbors);
}

}  // namespace
}  // namespace brindle
