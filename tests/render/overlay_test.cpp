#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/renderer.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

TEST(BranchOverlay, ShowsBranchesAndSingularitiesOnly) {
  const Mesh mesh = test::square(2);
  std::vector<CornerPhases> corners(mesh.triangle_count());
  corners[1].kind = TriangleKind::branch;
  corners[3].kind = TriangleKind::field_singularity;
  corners[4].kind = TriangleKind::regular;
  const Overlay overlay = branch_overlay(mesh, corners);
  ASSERT_EQ(overlay.triangle_colors.size(), mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    EXPECT_EQ(overlay.triangle_colors[t].amount > 0, t == 1 || t == 3);
  }
  ASSERT_EQ(overlay.marks.size(), 2u);
  EXPECT_FALSE(overlay.marks[0].color == overlay.marks[1].color);
  Vec3 centre = Vec3::Zero();
  for (const Index v : mesh.triangles[1]) centre += mesh.positions[v] / 3;
  EXPECT_TRUE(overlay.marks[0].position.isApprox(centre));
}

TEST(ErrorOverlay, LeavesTrianglesWithoutAValue) {
  const std::array<float, 4> values{-1, 0, 90, std::numeric_limits<float>::quiet_NaN()};
  const Overlay overlay = error_overlay(values, 90);
  ASSERT_EQ(overlay.triangle_colors.size(), 4u);
  EXPECT_EQ(overlay.triangle_colors[0].amount, 0);
  EXPECT_EQ(overlay.triangle_colors[3].amount, 0);
  EXPECT_EQ(overlay.triangle_colors[1].color, error_color(0));
  EXPECT_EQ(overlay.triangle_colors[2].color, error_color(1));
}

}  // namespace
}  // namespace brindle
