#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/polylines.h"
#include "test_points.h"

namespace brindle {
namespace {

using testing_support::line_of;

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
  }
  return sum;
}

TEST(Tubes, AreClosedAndWoundOutwards) {
  const Mesh open = tubes(line_of({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, false), {0.1f, 12});
  EXPECT_TRUE(manifold_twins(open).has_value());
  EXPECT_EQ(open.positions.size(), 36u);
  EXPECT_NEAR(volume(open), 3 * 6 * 0.01 * std::sin(std::numbers::pi / 6), 1e-4);

  const Mesh ring = tubes(line_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, true), {0.1f, 8});
  EXPECT_TRUE(manifold_twins(ring).has_value());
  EXPECT_EQ(ring.triangles.size(), 4u * 16);
  EXPECT_GT(volume(ring), 0);
}

TEST(Tubes, VerticesAreARadiusAwayFromTheLine) {
  const Polylines line = line_of({{0, 0, 0}, {1, 0.2f, 0}, {2, 0, 0.3f}}, false);
  const Mesh mesh = tubes(line, {0.05f, 6});
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR((mesh.positions[i] - line.points[i / 6]).norm(), 0.05f, 1e-6f);
  }
}

/// The least cosine between the ways out of their rings' centres of two vertices that a tube's edge
/// along the line joins.
float least_agreement(const Mesh& tube, const Polylines& line, Index sides) {
  float least = 1;
  for (const Triangle& t : tube.triangles) {
    for (int m = 0; m < 3; ++m) {
      const Index a = t[m], b = t[(m + 1) % 3];
      if (a / sides == b / sides) continue;
      const Vec3 from = tube.positions[a] - line.points[a / sides];
      const Vec3 to = tube.positions[b] - line.points[b / sides];
      least = std::min(least, from.normalized().dot(to.normalized()));
    }
  }
  return least;
}

TEST(Tubes, AreNotPinchedWhereNormalsChangeSides) {
  Polylines line = line_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, false);
  line.normals[2] = line.normals[3] = -line.normals[0];
  EXPECT_GT(least_agreement(tubes(line, {0.1f, 12}), line, 12), 0.8f);

  // As on a Moebius strip: half a turn on the way round.
  std::vector<Vec3> points, normals;
  for (int i = 0; i < 60; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / 60;
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
    normals.emplace_back(std::sin(angle / 2) * points.back() + std::cos(angle / 2) * Vec3(0, 0, 1));
  }
  Polylines ring = line_of(points, true);
  ring.normals = normals;
  const Mesh tube = tubes(ring, {0.1f, 12});
  EXPECT_GT(least_agreement(tube, ring, 12), 0.8f);
  EXPECT_TRUE(manifold_twins(tube).has_value());
}

TEST(Tubes, PassOverPointsThatNearlyRepeat) {
  const Mesh mesh =
      tubes(line_of({{0, 0, 0}, {1, 0, 0}, {1.0001f, 0, 0}, {2, 0, 0}, {2.0001f, 0, 0}}, false),
            {0.1f, 5});
  EXPECT_EQ(mesh.positions.size(), 15u);
  EXPECT_NEAR(mesh.positions.back().x(), 2.0001f, 1e-6f);
}

TEST(Tubes, LinesWithoutLengthHaveNone) {
  EXPECT_TRUE(tubes(line_of({{0, 0, 0}}, false), {}).triangles.empty());
  EXPECT_TRUE(tubes({}, {}).triangles.empty());
}

TEST(Tubes, RefuseWhatCannotBe) {
  for (const float radius : {0.0f, -1.0f, NAN, INFINITY})
    EXPECT_THROW(tubes({}, {radius, 8}), Error);
  EXPECT_THROW(tubes({}, {1, 2}), Error);
  EXPECT_THROW(tubes({}, {1, 65}), Error);
}

}  // namespace
}  // namespace brindle
