#include "brindle/creases.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/geometry/crease_edges.h"
#include "brindle/normals.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"
#include "extruded.h"

namespace brindle {
namespace {

Mesh cube_with_creases() { return extruded(square_round(4, 1), 2); }

TEST(CreasesTest, CornersOfABoxHaveThreeNormals) {
  Mesh mesh = cube_with_creases();
  const Creases creases = split_at_creases(mesh);
  // Eight corners with three faces each; the middles of two faces stay.
  EXPECT_EQ(creases.copied.size(), 16u);
  EXPECT_EQ(creases.edges.size(), 12u);
  EXPECT_TRUE(std::is_sorted(creases.copied.begin(), creases.copied.end()));
  const std::vector<Vec3> normals = vertex_normals(mesh);
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index v : triangle) {
      EXPECT_LT((normals[v] - triangle_normal(mesh, triangle)).norm(), 1e-6f);
    }
  }
}

TEST(CreasesTest, JoinedMeshesAreThoseBefore) {
  const Mesh before = extruded_ring(square_round(16, 3), toothed_circle(16, 1), 0.5f);
  Mesh mesh = before;
  const Creases creases = split_at_creases(mesh);
  ASSERT_FALSE(creases.empty());
  EXPECT_EQ(joined_mesh(mesh, creases).triangles, before.triangles);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const Index original = creases.original(static_cast<Index>(v), mesh.vertex_count());
    EXPECT_EQ(mesh.positions[v], before.positions[original]);
  }
  for (const CreaseEdge& edge : creases.edges) {
    for (int end = 0; end < 2; ++end) {
      EXPECT_EQ(creases.original(edge.first[end], mesh.vertex_count()),
                creases.original(edge.second[end], mesh.vertex_count()));
    }
  }
}

TEST(CreasesTest, WhatBendsLessIsNone) {
  for (const float degrees : {100.0f, 180.0f}) {
    Mesh mesh = cube_with_creases();
    const std::size_t count = mesh.vertex_count();
    EXPECT_TRUE(split_at_creases(mesh, degrees).empty()) << degrees;
    EXPECT_EQ(mesh.vertex_count(), count);
  }
}

TEST(CreasesTest, NoiseIsNone) {
  for (const char* shape : {"torus", "sphere,noise=0.3", "torus,noise=0.15", "torus,noise=0.3",
                            "torus,noise=0.3,noise_seed=2"}) {
    Mesh mesh = make_shape(shape);
    EXPECT_TRUE(split_at_creases(mesh).empty()) << shape;
  }
}

TEST(CreasesTest, OrderOfVerticesAndTrianglesDoesNotMatter) {
  const Mesh mesh = extruded(toothed_circle(48, 1, 0.8f), 0.3f);
  Mesh turned = mesh;
  std::reverse(turned.positions.begin(), turned.positions.end());
  std::reverse(turned.triangles.begin(), turned.triangles.end());
  const auto last = static_cast<Index>(mesh.vertex_count() - 1);
  for (Triangle& triangle : turned.triangles) {
    for (Index& v : triangle) v = last - v;
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
  }
  Mesh first = mesh;
  const Creases a = split_at_creases(first), b = split_at_creases(turned);
  EXPECT_EQ(a.edges.size(), b.edges.size());
  std::vector<Index> copied = b.copied;
  for (Index& v : copied) v = last - v;
  std::sort(copied.begin(), copied.end());
  EXPECT_EQ(a.copied, copied);
}

TEST(CreasesTest, WindingDoesNotMatter) {
  Mesh mesh = cube_with_creases();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  EXPECT_EQ(split_at_creases(mesh).copied.size(), 16u);
}

// Their walls bend from corner to corner, by up to 36 degrees.
TEST(CreasesTest, RimsOfCoarseHolesPart) {
  for (const int corners : {10, 11, 12, 16, 24}) {
    Mesh mesh = extruded_ring(toothed_circle(corners, 3), toothed_circle(corners, 1), 0.4f);
    EXPECT_EQ(split_at_creases(mesh).copied.size(), 4u * corners) << corners;
  }
}

TEST(CreasesTest, ConesPartFromCylinders) {
  constexpr Index kCorners = 16;
  Mesh mesh = extruded(toothed_circle(kCorners, 1), 2);
  mesh.positions.back().z() += 0.5f;
  // Its base, and the rim of its tip.
  EXPECT_EQ(split_at_creases(mesh).copied.size(), 2u * kCorners);
}

TEST(CreasesTest, FacesOfOneTrianglePart) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  EXPECT_EQ(split_at_creases(mesh).copied.size(), 8u);
}

/// A strip that is folded along its middle, whose height falls from row to row.
Mesh roof(float first, float last, Index rows = 21) {
  Mesh mesh;
  for (Index k = 0; k < rows; ++k) {
    const float share = static_cast<float>(k) / static_cast<float>(rows - 1);
    for (const float x : {-1.0f, 0.0f, 1.0f}) {
      mesh.positions.push_back(
          {x, static_cast<float>(k), x == 0 ? first + share * (last - first) : 0.0f});
    }
  }
  for (Index k = 0; k + 1 < rows; ++k) {
    for (const Index a : {3 * k, 3 * k + 1}) {
      mesh.triangles.push_back({a, a + 1, a + 4});
      mesh.triangles.push_back({a, a + 4, a + 3});
    }
  }
  return mesh;
}

TEST(CreasesTest, FoldsFromBorderToBorderPartAndShortFoldsThatRunOutDoNot) {
  Mesh whole = roof(1, 1), sinks = roof(1, 0);
  EXPECT_EQ(split_at_creases(whole).copied.size(), 21u);
  EXPECT_TRUE(split_at_creases(sinks).empty());
}

TEST(CreasesTest, LongFoldsPartUntilTheyRunOut) {
  Mesh sinks = roof(1, 0, 61);
  // The first 38 edges bend by more than 40 degrees.
  const std::size_t copies = split_at_creases(sinks).copied.size();
  EXPECT_GE(copies, 30u);
  EXPECT_LE(copies, 38u);
}

TEST(CreasesTest, SharpFoldsOfSheetsThatAreWoundAgainstEachOtherPart) {
  Mesh mesh = roof(20, 20);
  for (Triangle& triangle : mesh.triangles) {
    float x = 0;
    for (const Index v : triangle) x += mesh.positions[v].x();
    if (x < 0) std::swap(triangle[0], triangle[1]);
  }
  EXPECT_EQ(split_at_creases(mesh).copied.size(), 21u);
}

TEST(CreasesTest, UnitsDoNotMatter) {
  for (const float scale : {1e-8f, 1e8f}) {
    Mesh part = extruded(toothed_circle(48, 1, 0.8f), 0.3f), round = make_shape("torus");
    Mesh unscaled = part;
    const std::size_t copies = split_at_creases(unscaled).copied.size();
    for (Mesh* mesh : {&part, &round}) {
      for (Vec3& position : mesh->positions) position *= scale;
    }
    EXPECT_EQ(split_at_creases(part).copied.size(), copies) << scale;
    EXPECT_TRUE(split_at_creases(round).empty()) << scale;
  }
}

TEST(CreasesTest, ThreeSheetsAtAnEdgePartWhereTheyBend) {
  // A plane, and a wall upon it.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  mesh.triangles = {{2, 0, 1}, {0, 3, 1}, {0, 1, 4}};
  const Creases creases = split_at_creases(mesh);
  EXPECT_EQ(creases.copied, (std::vector<Index>{0, 1}));
  EXPECT_EQ(mesh.triangles[0][1], mesh.triangles[1][0]);
  EXPECT_NE(mesh.triangles[2][0], mesh.triangles[1][0]);
}

TEST(CreasesTest, RowsOfCopiesAreThoseOfTheirVertices) {
  Mesh mesh = cube_with_creases();
  std::vector<int> rows(mesh.vertex_count());
  std::iota(rows.begin(), rows.end(), 0);
  DataArrays arrays{{make_data_array("number", 1, std::vector<double>(rows.begin(), rows.end()))},
                    {}};
  const Creases creases = split_at_creases(mesh);
  add_rows_of_copies(creases, rows);
  add_rows_of_copies(creases, arrays);
  ASSERT_EQ(rows.size(), mesh.vertex_count());
  EXPECT_EQ(arrays.points[0].rows(), mesh.vertex_count());
  for (std::size_t v = 0; v < rows.size(); ++v) {
    EXPECT_EQ(static_cast<Index>(rows[v]),
              creases.original(static_cast<Index>(v), mesh.vertex_count()));
  }
}

TEST(CreasesTest, OtherAnglesAreRefused) {
  Mesh mesh = cube_with_creases();
  for (const float degrees : {-1.0f, 181.0f, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(split_at_creases(mesh, degrees), Error);
  }
}

TEST(CreasesTest, MeshesThatNoSurfaceHasAreRefused) {
  Mesh beyond = make_shape("box,resolution=5");
  beyond.triangles.back()[2] = static_cast<Index>(beyond.vertex_count());
  EXPECT_THROW(split_at_creases(beyond), Error);
  Mesh infinite = make_shape("box,resolution=5");
  infinite.positions.back().x() = std::numeric_limits<float>::infinity();
  EXPECT_THROW(split_at_creases(infinite), Error);
}

TEST(CreasesTest, SurfacesLinkBothSidesAndWarnOfNothing) {
  const Surface surface = with_creases(cube_with_creases());
  EXPECT_EQ(surface.own_vertex_count(), 10u);
  // Three pairs at each of eight corners.
  EXPECT_EQ(neighbors_over_creases(surface)->edge_count() - surface.neighborhood->edge_count(),
            24u);
  EXPECT_TRUE(surface_warnings(surface).empty());
  const Surface smooth = with_creases(make_shape("torus,resolution=64"));
  EXPECT_EQ(neighbors_over_creases(smooth), smooth.neighborhood);
}

// A crease bounds the faces on its two sides. Six flat faces of a cube; of a ring with a square
// outline, four flat walls, the wall of the hole, top and bottom.
TEST(CreasesTest, FacesHaveLoopsOfTheirOwn) {
  const auto boundaries = [](const Surface& surface) {
    const std::vector<SurfaceLoop> loops = surface_loops(surface);
    for (const SurfaceLoop& loop : loops) EXPECT_TRUE(loop.boundary) << loop.name;
    return loops.size();
  };
  EXPECT_EQ(boundaries(with_creases(cube_with_creases())), 6u);
  EXPECT_EQ(
      boundaries(with_creases(extruded_ring(square_round(16, 3), toothed_circle(16, 1), 0.5f))),
      4u + 2u + 2u + 2u);
}

}  // namespace
}  // namespace brindle
