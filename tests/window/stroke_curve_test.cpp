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

// A plane, seen from above, of which `there` says where it is and how high.
PickPlace seen_from_above(const std::function<std::optional<double>(double x)>& there) {
  return [there](const Eigen::Vector2d& pixel) -> std::optional<Eigen::Vector3d> {
    const auto height = there(pixel.x());
    if (!height) return std::nullopt;
    return Eigen::Vector3d(pixel.x(), pixel.y(), *height);
  };
}

bool leaves(const std::function<std::optional<double>(double)>& there) {
  const PickPlace pick = seen_from_above(there);
  const Eigen::Vector2d from(0, 0), to(5, 1);
  return leaves_surface({from, *pick(from)}, {to, *pick(to)}, pick);
}

TEST(StrokeCurveTest, LinesLeaveASurfaceAtHolesAndJumps) {
  EXPECT_FALSE(leaves([](double) { return 0; }));
  EXPECT_FALSE(leaves([](double x) { return 40 * x; })) << "steep, seen from the side";
  EXPECT_FALSE(leaves([](double x) { return 30 * std::sqrt(x); })) << "from the rim of a ball on";
  EXPECT_FALSE(leaves([](double x) { return std::abs(x - 1); })) << "over an edge";
  EXPECT_TRUE(leaves([](double x) -> std::optional<double> {
    return x > 1 && x < 4 ? std::nullopt : std::optional(0.0);
  })) << "a hole";
  for (const double at : {0.3, 2.0, 4.6}) {
    EXPECT_TRUE(leaves([at](double x) { return x < at ? 0 : 20; })) << "another part behind it";
  }
}

TEST(StrokeCurveTest, PixelsBetweenAreNearEachOther) {
  const auto pixels = pixels_between({0, 0}, {30, 40}, 5);
  ASSERT_EQ(pixels.size(), 10u);
  EXPECT_EQ(pixels.back(), Eigen::Vector2d(30, 40));
  EXPECT_TRUE(pixels.front().isApprox(Eigen::Vector2d(3, 4)));
  EXPECT_EQ(pixels_between({0, 0}, {1, 0}, 5), (std::vector<Eigen::Vector2d>{{1, 0}}));
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
