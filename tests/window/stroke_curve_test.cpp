#include "window/picture/stroke_curve.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace brindle::tool {
namespace {

const Points kBend = {{0, 0, 0}, {1, 0.5, 0}, {2, -1, 1}, {2.5, 3, -2}};

TEST(StrokeCurveTest, SplinesRunThroughTheirPoints) {
  const Points curve = catmull_rom(kBend, 6);
  ASSERT_EQ(curve.size(), 3 * 6 + 1);
  for (std::size_t i = 0; i < kBend.size(); ++i) EXPECT_TRUE(curve[6 * i].isApprox(kBend[i]));
}

TEST(StrokeCurveTest, SplinesAreParallelToTheLineBetweenNeighbours) {
  const Points curve = catmull_rom(kBend, 1000);
  const Eigen::Vector3d before = curve[1000] - curve[999];
  const Eigen::Vector3d after = curve[1001] - curve[1000];
  const Eigen::Vector3d along = (kBend[2] - kBend[0]).normalized();
  EXPECT_NEAR(before.normalized().dot(along), 1, 1e-5);
  EXPECT_NEAR(after.normalized().dot(along), 1, 1e-5);
}

TEST(StrokeCurveTest, SplinesOfALineStayOnIt) {
  const Points line = {{0, 0, 0}, {1, 2, 3}, {3, 6, 9}, {3.5, 7, 10.5}};
  for (const Eigen::Vector3d& point : catmull_rom(line, 7)) {
    EXPECT_LT(point.cross(Eigen::Vector3d(1, 2, 3)).norm(), 1e-12);
  }
}

TEST(StrokeCurveTest, FewPointsAreAsTheyAre) {
  EXPECT_TRUE(catmull_rom({}, 4).empty());
  EXPECT_EQ(catmull_rom(Points{{1, 2, 3}}, 4), (Points{{1, 2, 3}}));
  EXPECT_EQ(thinned(kBend, 4), kBend);
}

TEST(StrokeCurveTest, ThinnedLinesKeepTheirEnds) {
  Points points;
  for (int i = 0; i <= 100; ++i) points.emplace_back(i, 0, 0);
  const Points few = thinned(points, 11);
  ASSERT_EQ(few.size(), 11);
  for (int i = 0; i <= 10; ++i) EXPECT_EQ(few[static_cast<std::size_t>(i)].x(), 10 * i);
}

TEST(StrokeCurveTest, DistanceIsThatOfTheNearestPart) {
  const std::vector<Eigen::Vector2d> line = {{0, 0}, {10, 0}, {10, 10}};
  EXPECT_DOUBLE_EQ(distance_to_line({5, 3}, line), 3);
  EXPECT_DOUBLE_EQ(distance_to_line({-3, -4}, line), 5);
  EXPECT_DOUBLE_EQ(distance_to_line({12, 5}, line), 2);
  EXPECT_DOUBLE_EQ(distance_to_line({10, 10}, line), 0);
  EXPECT_TRUE(std::isinf(distance_to_line({0, 0}, {})));
}

}  // namespace
}  // namespace brindle::tool
