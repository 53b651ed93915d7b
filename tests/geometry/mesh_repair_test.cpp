#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/mesh.h"
#include "brindle/shapes.h"
#include "test_meshes.h"
#include "test_numbers.h"

namespace brindle {
namespace {

using testing_support::kInfinity;
using testing_support::kNaN;

const std::vector<Vec3> kSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(MeshRepair, LeavesGoodMeshesAlone) {
  for (const auto& [name, good] : every_shape()) {
    Mesh mesh = good;
    EXPECT_EQ(repair_mesh(mesh), MeshRepair{}) << name;
    EXPECT_EQ(mesh.triangles, good.triangles) << name;
    EXPECT_EQ(mesh.positions, good.positions) << name;
    EXPECT_EQ(join_vertices(mesh), 0u) << name;
  }
}

TEST(MeshRepair, SetsPositionsAsideThatAreNotFinite) {
  for (const float bad : {kNaN, kInfinity, -kInfinity, 1e30f}) {
    Mesh mesh{kSquare, {{0, 1, 2}, {0, 2, 4}}};
    mesh.positions.push_back({0, bad, 0});
    const MeshRepair repair = repair_mesh(mesh);
    EXPECT_EQ(repair.vertices_not_finite, 1u);
    EXPECT_EQ(repair.triangles_not_finite, 1u);
    EXPECT_EQ(mesh.positions[4], Vec3(0.5f, 0.5f, 0));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  }
}

TEST(MeshRepair, OfNothingButNaNLeavesZeroesAndNoTriangle) {
  Mesh mesh{std::vector<Vec3>(3, Vec3::Constant(kNaN)), {{0, 1, 2}}};
  EXPECT_EQ(repair_mesh(mesh).vertices_unreferenced, 3u);
  EXPECT_TRUE(mesh.triangles.empty());
  for (const Vec3& p : mesh.positions) EXPECT_EQ(p, Vec3(0, 0, 0));
}

TEST(MeshRepair, DropsTrianglesWithoutArea) {
  Mesh mesh{kSquare, {{0, 1, 1}, {0, 1, 2}, {2, 2, 2}, {0, 4, 1}, {0, 5, 1}}};
  mesh.positions.push_back({2, 0, 0});  // on the line through 0 and 1
  mesh.positions.push_back({0, 0, 0});  // where 0 is
  EXPECT_EQ(repair_mesh(mesh).triangles_degenerate, 4u);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(MeshRepair, KeepsSmallAndThinTriangles) {
  for (const float scale : {1e-12f, 1.0f, 1e12f}) {
    Mesh mesh{{{0, 0, 0}, {scale, 0, 0}, {0.5f * scale, 1e-6f * scale, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(repair_mesh(mesh), MeshRepair{}) << scale;
  }
}

TEST(MeshRepair, DropsCornersOutOfRange) {
  Mesh mesh{kSquare, {{0, 1, 2}, {0, 1, 4}, {0, 1, 4294967295u}}};
  EXPECT_EQ(repair_mesh(mesh).triangles_out_of_range, 2u);
  EXPECT_EQ(mesh.triangle_count(), 1u);
}

TEST(MeshRepair, DropsTrianglesThatStandTwiceWhateverTheirWinding) {
  Mesh mesh{kSquare, {{2, 3, 0}, {0, 1, 2}, {1, 2, 0}, {0, 2, 1}, {0, 1, 3}}};
  EXPECT_EQ(repair_mesh(mesh).triangles_duplicate, 2u);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{2, 3, 0}, {0, 1, 2}, {0, 1, 3}}));
}

TEST(MeshRepair, CountsButKeepsUnusedVertices) {
  Mesh mesh{kSquare, {{0, 1, 2}}};
  EXPECT_EQ(repair_mesh(mesh).vertices_unreferenced, 1u);
  EXPECT_EQ(mesh.vertex_count(), 4u);
}

TEST(MeshRepair, JoinsOnlyWhatIsExactlyAtOnePlace) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-0.0f, 1, 0}, {1, 1e-7f, 0}, {0, 0, 1}},
            {{0, 1, 2}, {3, 6, 4}, {0, 5, 6}}};
  EXPECT_EQ(join_vertices(mesh), 2u);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 6, 2}, {0, 5, 6}}));
  drop_unreferenced_vertices(mesh);
  EXPECT_EQ(mesh.positions,
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1e-7f, 0}, {0, 0, 1}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 4, 2}, {0, 3, 4}}));
}

TEST(MeshRepair, JoinsNothingThatIsNaN) {
  Mesh mesh{std::vector<Vec3>(1000, Vec3::Constant(kNaN)), {{0, 1, 2}}};
  EXPECT_EQ(join_vertices(mesh), 0u);
}

TEST(MeshRepair, IsDescribedInWords) {
  EXPECT_EQ(describe(MeshRepair{}), "");
  EXPECT_NE(describe(MeshRepair{.triangles_degenerate = 3}).find("3 triangles without area"),
            std::string::npos);
}

}  // namespace
}  // namespace brindle
