#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"
#include "brindle/shapes.h"
#include "parametric_meshes.h"

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
  EXPECT_TRUE(manifold_twins(fine).has_value());
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

/// How far points are off the sphere of radius 1, at most.
float off_the_sphere(const Mesh& mesh) {
  float most = 0;
  for (const Vec3& p : mesh.positions) most = std::max(most, std::abs(p.norm() - 1));
  return most;
}

TEST(Subdivide, RoundedMakesACoarseSphereRound) {
  const Mesh coarse = make_sphere({.resolution = 8});
  const float straight = off_the_sphere(subdivide(coarse, 3));
  EXPECT_LT(off_the_sphere(subdivide(coarse, 3, Midpoints::rounded)), 0.05f * straight);
  const Mesh once = subdivide(coarse, 1, Midpoints::rounded);
  EXPECT_TRUE(std::equal(coarse.positions.begin(), coarse.positions.end(), once.positions.begin()));
  EXPECT_EQ(once.triangles, subdivide(coarse, 1).triangles);
}

TEST(Subdivide, RoundedLeavesFlatFacesAndTheirEdgesAlone) {
  Mesh cube;
  for (int i = 0; i < 8; ++i) {
    cube.positions.emplace_back(static_cast<float>(i & 1), static_cast<float>(i >> 1 & 1),
                                static_cast<float>(i >> 2));
  }
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const Mesh straight = subdivide(cube, 3), rounded = subdivide(cube, 3, Midpoints::rounded);
  for (std::size_t i = 0; i < straight.vertex_count(); ++i) {
    EXPECT_LT((rounded.positions[i] - straight.positions[i]).norm(), 1e-6f) << i;
  }
}

TEST(Subdivide, RoundedDoesNotDependOnWindingsAndOrder) {
  Mesh mesh = make_shape("trefoil,resolution=12");
  const Mesh fine = subdivide(mesh, 2, Midpoints::rounded);
  for (std::size_t t = 0; t < mesh.triangle_count(); t += 3) {
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  const Mesh turned = subdivide(mesh, 2, Midpoints::rounded);
  ASSERT_EQ(turned.vertex_count(), fine.vertex_count());
  const Mesh straight = subdivide(mesh, 2);
  float moved = 0;
  for (std::size_t i = 0; i < fine.vertex_count(); ++i) {
    EXPECT_LT((turned.positions[i] - fine.positions[i]).norm(), 1e-5f) << i;
    moved = std::max(moved, (fine.positions[i] - straight.positions[i]).norm());
  }
  EXPECT_GT(moved, 0.003f);
}

TEST(Subdivide, RoundedKeepsEdgesOfThreeTrianglesStraight) {
  // Three fins round a common edge, and a fold of 90 degrees.
  const Mesh fins{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
                  {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  const Mesh fold{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  for (const Mesh& mesh : {fins, fold}) {
    EXPECT_EQ(subdivide(mesh, 1, Midpoints::rounded).positions, subdivide(mesh, 1).positions);
  }
}

TEST(Subdivide, RefusesWhatCannotBeNumbered) {
  const Mesh one{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  EXPECT_THROW(subdivide(one, -1), Error);
  EXPECT_THROW(subdivide(one, 16), Error);
  EXPECT_EQ(subdivide(Mesh{}, 1000).vertex_count(), 0u);
}

}  // namespace
}  // namespace brindle
