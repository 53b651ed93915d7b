#include "brindle/geometry/topology.h"

#include <algorithm>
#include <array>
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
    using Pairs = std::vector<std::pair<Index, Index>>;
    Pairs edges;
    for (const Triangle& t : mesh.triangles) {
      for (int c = 0; c < 3; ++c) {
        edges.emplace_back(t[c], t[(c + 1) % 3]);
        edges.emplace_back(t[(c + 1) % 3], t[c]);
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const Adjacency neighborhood = vertex_neighborhood(mesh);
    Pairs found;
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
        const Index half_edge = 3 * static_cast<Index>(t) + static_cast<Index>(m);
        ASSERT_EQ(edges.half_edges.of(edge)[counts[edge]++], half_edge);
        ASSERT_EQ(edges.between(a, b), edge);
      }
    }
    for (Index e = 0; e < edges.count(); ++e) ASSERT_EQ(edges.triangle_count(e), counts[e]);
  }
}

TEST(MeshEdges, LeadFromTriangleToTriangle) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                  {{0, 1, 2}, {3, 2, 1}, {1, 4, 3}, {1, 3, 5}}};
  const MeshEdges edges = mesh_edges(mesh, vertex_neighborhood(mesh));
  EXPECT_EQ(edges.beyond(0, 1), 1u);
  EXPECT_EQ(edges.beyond(1, 1), 0u);
  EXPECT_EQ(edges.beyond(0, 0), kNoTriangle) << "a boundary";
  EXPECT_EQ(edges.beyond(1, 2), kNoTriangle) << "three triangles";
  EXPECT_EQ(edges.triangles(edges.between(0, 1)), (std::array{Index{0}, kNoTriangle}));
  EXPECT_EQ(edges.triangles(edges.between(3, 1)), (std::array{Index{1}, Index{2}}));
}

// They have no area, but readers of other programs' meshes may keep them.
TEST(MeshEdges, OfTrianglesWithTwoCornersAlikeAreOthers) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}};
  EXPECT_EQ(mesh_edges(mesh, vertex_neighborhood(mesh)).count(), 1u);
  const Mesh point{{{0, 0, 0}}, {{0, 0, 0}}};
  EXPECT_EQ(mesh_edges(point, vertex_neighborhood(point)).count(), 0u);
}

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

TEST(Twins, AreOfClosedManifoldsWoundAlike) {
  EXPECT_TRUE(manifold_twins(every_shape().at("sphere")).has_value());
  for (const char* name : {"plane", "mobius", "sheets"}) {
    EXPECT_FALSE(manifold_twins(every_shape().at(name)).has_value()) << name;
  }
  // Two tetrahedra that meet at one vertex: their triangles there form two fans.
  Mesh mesh{std::vector<Vec3>(7, Vec3::Zero()), {}};
  for (const Index i : {0u, 3u}) {
    const std::array<Index, 4> v = {0, i + 1, i + 2, i + 3};
    mesh.triangles.insert(
        mesh.triangles.end(),
        {{v[0], v[1], v[2]}, {v[0], v[2], v[3]}, {v[0], v[3], v[1]}, {v[1], v[3], v[2]}});
  }
  EXPECT_FALSE(manifold_twins(mesh).has_value());
  mesh.triangles.resize(4);
  EXPECT_TRUE(manifold_twins(mesh).has_value());
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_FALSE(manifold_twins(mesh).has_value()) << "wound against its neighbours";
}

TEST(Twins, AreThoseOfEdgesOfTwoTriangles) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 2, 1}, {1, 4, 3}, {1, 3, 5}};
  const std::vector<Index> twins = twins_of(triangles);
  EXPECT_EQ(twins[1], 4u);
  EXPECT_EQ(twins[4], 1u);
  EXPECT_EQ(twins[0], kNoTwin);
  for (const Index h : {5u, 8u, 9u}) EXPECT_EQ(twins[h], kManyTwins);
}

}  // namespace
}  // namespace brindle
