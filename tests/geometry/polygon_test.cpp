#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/mesh.h"

namespace brindle {
namespace {

std::vector<Triangle> cut(const std::vector<Vec3>& corners) {
  std::vector<Index> numbers(corners.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::vector<Triangle> triangles;
  triangulate_polygon(corners, numbers, triangles);
  return triangles;
}

/// The z components of all triangles' areas, which must not cancel.
std::pair<float, float> signed_and_total_area(const std::vector<Vec3>& p) {
  float sum = 0, total = 0;
  for (const auto& [a, b, c] : cut(p)) {
    const float area = 0.5f * (p[b] - p[a]).cross(p[c] - p[a])[2];
    sum += area;
    total += std::abs(area);
  }
  return {sum, total};
}

TEST(Polygon, WithTooFewCornersIsNothing) { EXPECT_TRUE(cut({{0, 0, 0}, {1, 0, 0}}).empty()); }

TEST(Polygon, ConvexQuadrangleIsCutAlongItsShorterDiagonal) {
  EXPECT_EQ(cut({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 1, 0}}),
            (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Polygon, ConcaveQuadrangleIsCutInside) {
  for (int shift = 0; shift < 4; ++shift) {
    std::vector<Vec3> arrow = {{0, 0, 0}, {2, -1, 0}, {0.5f, 0, 0}, {2, 1, 0}};
    std::rotate(arrow.begin(), arrow.begin() + shift, arrow.end());
    const auto [sum, total] = signed_and_total_area(arrow);
    EXPECT_FLOAT_EQ(std::abs(sum), total);
  }
}

TEST(Polygon, StarIsCutInside) {
  for (const float direction : {1.f, -1.f}) {
    std::vector<Vec3> star;
    for (int i = 0; i < 14; ++i) {
      const float r = i % 2 ? 0.3f : 1.0f, angle = direction * static_cast<float>(i) * 0.448799f;
      star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    EXPECT_EQ(cut(star).size(), 12u);
    const auto [sum, total] = signed_and_total_area(star);
    EXPECT_NEAR(std::abs(sum), total, 1e-5f);
    EXPECT_GT(sum * direction, 0) << "triangles are wound as the polygon is";
  }
}

TEST(Polygon, BadCoordinatesEndInSomeTriangles) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(cut(std::vector<Vec3>(9, Vec3::Constant(nan))).size(), 7u);
  EXPECT_EQ(cut(std::vector<Vec3>(9, Vec3::Zero())).size(), 7u);
  EXPECT_EQ(cut(std::vector<Vec3>(5000, Vec3::Zero())).size(), 4998u);
}

}  // namespace
}  // namespace brindle
