#include "brindle/shapes/capsules.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/base/random.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

Point random_point(std::uint64_t& drawn, double reach) {
  Point p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = reach * (2 * random_number(9, drawn++) - 1);
  return p;
}

std::vector<Capsule> many_capsules(std::size_t count) {
  std::uint64_t drawn = 0;
  std::vector<Capsule> parts;
  for (std::size_t i = 0; i < count; ++i) {
    const Point a = random_point(drawn, 1), b = a + random_point(drawn, 0.2);
    parts.push_back({a, b, 0.03, 0.05});
  }
  return parts;
}

TEST(CapsuleDistance, IsThatOfASphereAndOfATube) {
  const CapsuleDistance sphere({{1, 2, 3}, {1, 2, 3}, 0.5, 0.5});
  EXPECT_DOUBLE_EQ(sphere({1, 2, 5}), 1.5);
  const CapsuleDistance tube({{0, 0, 0}, {0, 0, 4}, 0.5, 0.5});
  EXPECT_DOUBLE_EQ(tube({2, 0, 1}), 1.5);
  EXPECT_DOUBLE_EQ(tube({0, 0, 7}), 2.5);
  EXPECT_DOUBLE_EQ(tube({0.2, 0, 1}), -0.3);
}

// With so many parts there is a grid; the plain sum over all of them is what it must find.
TEST(CapsuleUnion, OfManyPartsIsTheSmoothMinimumOfAll) {
  const std::vector<Capsule> parts = many_capsules(300);
  const double blend = 0.02;
  const CapsuleUnion grid(parts, blend);
  std::uint64_t drawn = 1 << 20;
  for (int i = 0; i < 2000; ++i) {
    const Point p = random_point(drawn, 1.5);  // also beyond the grid
    double nearest = 1e30, sum = 0;
    for (const Capsule& part : parts) nearest = std::min(nearest, CapsuleDistance(part)(p));
    for (const Capsule& part : parts) sum += std::exp((nearest - CapsuleDistance(part)(p)) / blend);
    EXPECT_NEAR(grid(p), nearest - blend * std::log(sum), 1e-8);
  }
}

TEST(CapsuleSurface, IsClosedAndWhereTheUnionIsZero) {
  const std::vector<Capsule> parts = {{{0, 0, 0}, {1, 0, 0}, 0.3, 0.2},
                                      {{1, 0, 0}, {1.4, 0.6, 0}, 0.2, 0.15}};
  const Mesh mesh = capsule_surface(parts, 0.05, 0.06f);
  EXPECT_TRUE(manifold_twins(mesh).has_value());
  const CapsuleUnion expected(parts, 0.05);
  for (const Vec3& p : mesh.positions) EXPECT_NEAR(expected(p.cast<double>()), 0, 1e-3);
}

}  // namespace
}  // namespace brindle
