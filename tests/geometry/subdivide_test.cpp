#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/geometry/half_edges.h"
#include "brindle/geometry/neighborhood.h"
#include "brindle/mesh.h"
#include "brindle/shapes/parametric_shapes.h"

namespace brindle {
namespace {

TEST(Subdivide, MakesFourOfOne) {
  const Mesh mesh = subdivide({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}});
  EXPECT_EQ(mesh.positions,
            (std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 3, 4}, {3, 1, 5}, {4, 5, 2}, {3, 5, 4}}));
}

TEST(Subdivide, ZeroTimesChangesNothing) {
  const Mesh mesh = make_torus({.resolution = 20});
  EXPECT_EQ(subdivide(mesh, 0).positions, mesh.positions);
  EXPECT_EQ(subdivide(mesh, 0).triangles, mesh.triangles);
}

TEST(Subdivide, KeepsOldVerticesFirst) {
  const Mesh mesh = make_torus({.resolution = 20});
  const Mesh fine = subdivide(mesh, 2);
  EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), fine.positions.begin()));
}

TEST(Subdivide, KeepsAManifoldClosed) {
  const Mesh mesh = make_torus({.resolution = 20});
  const Mesh fine = subdivide(mesh, 2);
  EXPECT_TRUE(half_edges(fine).has_value());
  EXPECT_EQ(fine.triangle_count(), 16 * mesh.triangle_count());
  EXPECT_EQ(fine.vertex_count(), 16 * mesh.vertex_count()) << "V = T / 2 on a torus";
}

TEST(Subdivide, SharesMidpointsOfNonManifoldEdges) {
  const Mesh sheets = make_sheets({.resolution = 4});
  const std::size_t edges = vertex_neighborhood(sheets).edge_count();
  EXPECT_EQ(subdivide(sheets).vertex_count(), sheets.vertex_count() + edges);
}

TEST(Subdivide, KeepsUnusedVertices) {
  const Mesh mesh = subdivide({{{9, 9, 9}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{1, 2, 3}}});
  EXPECT_EQ(mesh.vertex_count(), 7u);
  EXPECT_EQ(mesh.positions[0], Vec3(9, 9, 9));
}

TEST(Subdivide, RefusesWhatCannotBeNumbered) {
  const Mesh one{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  EXPECT_THROW(subdivide(one, -1), Error);
  EXPECT_THROW(subdivide(one, 16), Error);
  EXPECT_EQ(subdivide(Mesh{}, 1000).vertex_count(), 0u);
}

}  // namespace
}  // namespace brindle
