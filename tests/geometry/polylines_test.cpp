#include "brindle/polylines.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "test_points.h"

namespace brindle {
namespace {

using testing_support::line_of;

Polylines circle(int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
  }
  return line_of(points, true);
}

TEST(Polylines, LengthHasTheWayBackOfClosedLines) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(length_of(line_of(square, false), 0), 3);
  EXPECT_EQ(length_of(line_of(square, true), 0), 4);
}

TEST(Simplified, KeepsEndsAndCorners) {
  const Polylines bent =
      line_of({{0, 0, 0}, {1, 0, 0}, {2, 0.01f, 0}, {3, 0, 0}, {3, 1, 0}, {3, 2, 0}}, false);
  EXPECT_EQ(simplified(bent, 0.1f).points, (std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}}));
  EXPECT_EQ(simplified(bent, 0).points.size(), 5u) << "the middle of a straight part is no corner";
}

TEST(Simplified, StaysWithinTheTolerance) {
  const Polylines round = circle(400);
  for (const float tolerance : {0.001f, 0.01f, 0.1f}) {
    const Polylines fewer = simplified(round, tolerance);
    ASSERT_TRUE(fewer.closed[0]);
    EXPECT_LT(fewer.points.size(), round.points.size());
    for (std::size_t i = 0; i < fewer.points.size(); ++i) {
      const Vec3 middle = (fewer.points[i] + fewer.points[(i + 1) % fewer.points.size()]) / 2;
      EXPECT_GE(middle.norm(), 1 - 1.1f * tolerance);
    }
  }
}

TEST(Resampled, StepsAreEqualAndEndsStay) {
  const Polylines bent = line_of({{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {5, 3, 0}}, false);
  const Polylines even = resampled(bent, 0.9f);
  ASSERT_EQ(even.points.size(), 10u);
  EXPECT_EQ(even.points.front(), bent.points.front());
  EXPECT_EQ(even.points.back(), bent.points.back());
  for (std::size_t i = 0; i < even.points.size(); ++i) {
    const Vec3& p = even.points[i];
    EXPECT_NEAR(p.x() + p.y(), 8.0f / 9 * static_cast<float>(i), 1e-5f);
    EXPECT_TRUE(p.y() == 0 || p.x() == 5) << "on the line";
  }
}

TEST(Resampled, ClosedLinesStayClosed) {
  const Polylines even = resampled(circle(1000), 0.1f);
  ASSERT_TRUE(even.closed[0]);
  ASSERT_EQ(even.points.size(), 63u);
  for (std::size_t i = 0; i < even.points.size(); ++i) {
    const Vec3& next = even.points[(i + 1) % even.points.size()];
    EXPECT_NEAR((next - even.points[i]).norm(), 0.0997f, 2e-4f);
    EXPECT_NEAR(even.normals[i].z(), 1, 1e-6f);
  }
}

TEST(Resampled, PlacesFollowTheirSegments) {
  // Along the edge 0-1 of triangle 4, then through triangle 7.
  Polylines lines = line_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, false);
  lines.places = {{4, {1, 0, 0}}, {7, {0, 1, 0}}, {7, {0, 0.5, 0.5}}};
  lines.arrivals = {{0, 1, 0}, {0, 0.5, 0.5}, {0, 0.5, 0.5}};
  const Polylines even = resampled(lines, 1);
  ASSERT_EQ(even.places.size(), 5u);
  EXPECT_EQ(even.places[1].triangle, 4u);
  EXPECT_EQ(even.places[1].barycentric, (std::array<double, 3>{0.5, 0.5, 0}));
  EXPECT_EQ(even.places[3].triangle, 7u);
  EXPECT_EQ(even.places[3].barycentric, (std::array<double, 3>{0, 0.75, 0.25}));
  EXPECT_EQ(even.places[4].barycentric, lines.places[2].barycentric);
  const Polylines fewer = simplified(lines, 0.1f);
  EXPECT_EQ(fewer.places.size(), 3u);
  // Nobody knows any more where the segments run.
  EXPECT_TRUE(fewer.arrivals.empty());
  EXPECT_TRUE(resampled(fewer, 1).places.empty());
}

TEST(Resampled, RefusesImpossibleSpacings) {
  for (const float spacing : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), 1e-20f}) {
    EXPECT_THROW(resampled(circle(8), spacing), Error) << spacing;
  }
}

}  // namespace
}  // namespace brindle
