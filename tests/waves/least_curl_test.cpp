#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/shapes.h"
#include "brindle/surface.h"
#include "brindle/waves/circulation.h"

namespace brindle {
namespace {

/// Directions of lines that differ by a half turn are the same.
double line_angle(double radians) { return std::remainder(radians, std::numbers::pi); }

/// Away from a point beside the plane: no curl, and a divergence that is not zero.
DirectionField away_from_a_point(const Surface& surface) {
  DirectionField field;
  for (const Vec3& x : surface.mesh.positions) {
    const Vec3 from(-3, 0.4f, x.z());
    field.push_back((x - from).normalized());
  }
  return field;
}

TEST(LeastCurl, OfAFieldWithoutCurlIsThatField) {
  const Surface plane = make_surface(make_shape("plane,resolution=24"));
  const CurlSums sums = curl_sums(plane.mesh, away_from_a_point(plane), plane.normals);
  EXPECT_LT(sums.curl, 1e-3 * sums.divergence) << "but for what a coarse mesh adds";
  EXPECT_NEAR(least_curl_angle(sums), 0, 1e-3);
}

TEST(LeastCurl, TurnsBackWhatWasTurned) {
  const Surface plane = make_surface(make_shape("plane,resolution=24"));
  const DirectionField field = away_from_a_point(plane);
  for (const float angle : {-1.5f, -0.7f, 0.2f, 1.1f, std::numbers::pi_v<float> / 2}) {
    const DirectionField turned = rotated(field, plane.normals, angle);
    const float back = least_curl_angle(curl_sums(plane.mesh, turned, plane.normals));
    EXPECT_NEAR(line_angle(back + angle), 0, 1e-3) << angle;
  }
}

TEST(LeastCurl, DoesNotDependOnSigns) {
  const Surface plane = make_surface(make_shape("plane,resolution=24"));
  DirectionField field = rotated(away_from_a_point(plane), plane.normals, 0.6f);
  const CurlSums before = curl_sums(plane.mesh, field, plane.normals);
  for (std::size_t i = 0; i < field.size(); i += 3) field[i] = -field[i];
  const CurlSums after = curl_sums(plane.mesh, field, plane.normals);
  EXPECT_NEAR(after.curl, before.curl, 1e-6 * before.curl);
  EXPECT_NEAR(after.divergence, before.divergence, 1e-6 * before.divergence);
  EXPECT_NEAR(after.mixed, before.mixed, 1e-6 * std::abs(before.mixed));
}

/// Turning by 90 degrees makes curl divergence and divergence curl.
TEST(LeastCurl, OfTheFieldTurnedByARightAngleChangesPlaces) {
  const Surface torus = make_surface(make_shape("torus,resolution=40"));
  DirectionField around;
  for (std::size_t v = 0; v < torus.normals.size(); ++v) {
    const Vec3 axis = Vec3(0.3f, 1, 0.2f).normalized();
    const Vec3 tangent = axis - axis.dot(torus.normals[v]) * torus.normals[v];
    around.push_back(tangent.norm() > 0.2f ? tangent.normalized() : Vec3::Zero());
  }
  const CurlSums sums = curl_sums(torus.mesh, around, torus.normals);
  const CurlSums turned = curl_sums(
      torus.mesh, rotated(around, torus.normals, std::numbers::pi_v<float> / 2), torus.normals);
  EXPECT_NEAR(turned.curl, sums.divergence, 1e-4 * sums.divergence);
  EXPECT_NEAR(turned.divergence, sums.curl, 1e-4 * sums.curl);
}

TEST(LeastCurl, PaysWhereItIsLessThanHalf) {
  EXPECT_TRUE(is_much_curled({10, 4, 0}));
  EXPECT_FALSE(is_much_curled({10, 6, 0}));
  EXPECT_TRUE(is_much_curled({10, 10, 9})) << "least 1";
  EXPECT_FALSE(is_much_curled({4, 10, 0})) << "least as it is";
  EXPECT_FALSE(is_much_curled({1e-3, 0, 0})) << "no stripe shows it";
}

TEST(LeastCurl, OnlyWhatNothingPullsTurnsFreely) {
  PhaseGraph graph;
  graph.reflecting = {0, 0};
  EXPECT_TRUE(turns_freely(graph, 1));
  EXPECT_TRUE(turns_freely(graph, 2));
  EXPECT_FALSE(turns_freely(graph, 4)) << "both waves of a cross have the same curl in sum";
  graph.anchor = {0, 0};
  EXPECT_TRUE(turns_freely(graph, 2));
  graph.anchor = {0, Complex(0, 0.1f)};
  EXPECT_FALSE(turns_freely(graph, 2));
  graph.anchor.clear();
  graph.reflecting = {0, 1};
  EXPECT_FALSE(turns_freely(graph, 2));
}

}  // namespace
}  // namespace brindle
