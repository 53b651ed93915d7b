#include "brindle/strokes.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/shapes.h"

namespace brindle {
namespace {

using Vec3d = Eigen::Vector3d;

Surface plane() { return make_surface(make_shape("plane,resolution=40")); }

FieldStroke slanted() { return {{Vec3d(-0.6, -0.3, 0), Vec3d(0.6, 0.3, 0)}, 0.2, 1.5}; }

bool same(const std::vector<FieldAnchor>& a, const std::vector<FieldAnchor>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const FieldAnchor& x, const FieldAnchor& y) {
        return x.vertex == y.vertex && x.direction == y.direction && x.weight == y.weight;
      });
}

std::string message(const Surface& surface, const std::vector<FieldStroke>& strokes) {
  try {
    stroke_anchors(surface, strokes);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Strokes, DrawAlongTheLineAndLessFartherAway) {
  const Surface surface = plane();
  const FieldStroke stroke = slanted();
  const Vec3 along = Vec3(2, 1, 0).normalized();
  const Vec3 across(-along.y(), along.x(), 0);
  std::size_t in_the_middle = 0;
  for (const FieldAnchor& anchor : stroke_anchors(surface, std::vector{stroke})) {
    EXPECT_NEAR(std::abs(anchor.direction.dot(along)), 1, 1e-5);
    const Vec3& p = surface.mesh.positions[anchor.vertex];
    EXPECT_LE(anchor.weight, 1.5f + 1e-5f);
    if (std::abs(p.dot(along)) > 0.5f) continue;
    ++in_the_middle;
    const float share = p.dot(across) / 0.2f;
    EXPECT_LT(std::abs(share), 1);
    EXPECT_NEAR(anchor.weight, 1.5f * std::pow(1 - share * share, 2), 0.03f);
  }
  EXPECT_GT(in_the_middle, 50u);
}

TEST(Strokes, ReadBackwardsAreTheSameBitForBit) {
  const Surface surface = make_surface(make_shape("sphere,resolution=12"));
  FieldStroke stroke{{Vec3d(1, 0, 0), Vec3d(0.8, 0.6, 0), Vec3d(0.6, 0.64, 0.48)}, 0.3, 1};
  const auto forward = stroke_anchors(surface, std::vector{stroke});
  std::reverse(stroke.points.begin(), stroke.points.end());
  EXPECT_TRUE(same(stroke_anchors(surface, std::vector{stroke}), forward));
  EXPECT_GT(forward.size(), 10u);
}

TEST(Strokes, MoveWithTheSurface) {
  Surface surface = make_surface(make_shape("sphere,resolution=12"));
  FieldStroke stroke{{Vec3d(1, 0, 0), Vec3d(0.8, 0.6, 0), Vec3d(0.6, 0.64, 0.48)}, 0.3, 1};
  const auto before = stroke_anchors(surface, std::vector{stroke});
  const Eigen::AngleAxisd turn(0.8, Vec3d(1, 2, 3).normalized());
  const Vec3d shift(4, -3, 1);
  for (Vec3& p : surface.mesh.positions) p = (turn * p.cast<double>()).cast<float>();
  surface.mesh.origin = shift;
  surface = make_surface(surface.mesh);
  for (Vec3d& p : stroke.points) p = turn * p + shift;
  const auto after = stroke_anchors(surface, std::vector{stroke});
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].vertex, before[i].vertex);
    EXPECT_NEAR(after[i].weight, before[i].weight, 1e-4);
    const Vec3 turned = (turn * before[i].direction.cast<double>()).cast<float>();
    EXPECT_NEAR(std::abs(after[i].direction.dot(turned)), 1, 1e-3);
  }
}

TEST(Strokes, HardlyDependOnHowTheyAreDivided) {
  const Surface surface = plane();
  const FieldStroke coarse = slanted();
  FieldStroke fine = coarse;
  fine.points.clear();
  for (int i = 0; i <= 50; ++i) {
    fine.points.push_back(coarse.points[0] + i / 50.0 * (coarse.points[1] - coarse.points[0]));
  }
  const auto a = stroke_anchors(surface, std::vector{coarse});
  const auto b = stroke_anchors(surface, std::vector{fine});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i].weight, b[i].weight, 1e-4);
}

TEST(Strokes, ReachCornersOfTrianglesThatAreLargerThanTheRadius) {
  const Surface surface = make_surface(make_shape("plane,resolution=4"));
  FieldStroke stroke = slanted();
  stroke.radius = 1e-3;
  EXPECT_GE(stroke_anchors(surface, std::vector{stroke}).size(), 3u);
}

TEST(Strokes, DoNotReachTheOtherSideOfASheet) {
  // Two planes, one close below the other.
  Mesh mesh = make_shape("plane,resolution=20");
  const auto count = static_cast<Index>(mesh.vertex_count());
  const Mesh upper = mesh;
  for (const Vec3& p : upper.positions) mesh.positions.push_back(p - 0.05f * Vec3::UnitZ());
  for (Triangle t : upper.triangles) {
    for (Index& v : t) v += count;
    mesh.triangles.push_back(t);
  }
  for (const FieldAnchor& a : stroke_anchors(make_surface(mesh), std::vector{slanted()})) {
    EXPECT_LT(a.vertex, count);
  }
}

TEST(Strokes, OnPointsAloneAreTaken) {
  Surface surface = plane();
  surface.mesh.triangles.clear();
  EXPECT_GT(stroke_anchors(surface, std::vector{slanted()}).size(), 20u);
}

TEST(Strokes, ThatAreNoneAreNamed) {
  const Surface surface = plane();
  const double nan = std::nan("");
  const auto with = [](const std::function<void(FieldStroke&)>& change) {
    std::vector<FieldStroke> strokes(2, slanted());
    change(strokes[1]);
    return strokes;
  };
  const auto expect = [&](const char* part, const std::function<void(FieldStroke&)>& change) {
    const std::string text = message(surface, with(change));
    EXPECT_NE(text.find("strokes[1]"), std::string::npos) << text;
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  expect("point 1", [&](FieldStroke& s) { s.points[1].y() = nan; });
  expect("no length", [](FieldStroke& s) { s.points.clear(); });
  expect("no length", [](FieldStroke& s) { s.points.resize(1); });
  expect("no length", [](FieldStroke& s) { s.points[1] = s.points[0]; });
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    expect("radius", [&](FieldStroke& s) { s.radius = bad; });
  }
  for (const double bad : {-1.0, nan, 1e7}) {
    expect("strength", [&](FieldStroke& s) { s.strength = bad; });
  }
  expect("2.5", [](FieldStroke& s) { s.points[1].z() = 2.5; });
  expect("point 1 is", [](FieldStroke& s) { s.points[1].z() = 2.5; });
  EXPECT_TRUE(stroke_anchors(surface, {}).empty());
}

TEST(Strokes, ThatLeaveTheSurfaceBetweenTheirPointsAreRefused) {
  const Surface sphere = make_surface(make_shape("sphere,resolution=12"));
  const FieldStroke chord{{Vec3d(1, 0, 0), Vec3d(-0.8, 0.6, 0)}, 0.1, 1};
  EXPECT_NE(message(sphere, {chord}).find("between two of its points"), std::string::npos);
}

TEST(Strokes, OfFeaturesRunFromCornerToCorner) {
  const Surface surface = plane();
  const auto strokes = feature_strokes(surface, 40, 0.1, 1);
  ASSERT_EQ(strokes.size(), 4u);
  double length = 0;
  for (const FieldStroke& stroke : strokes) {
    EXPECT_GT(stroke.points.size(), 30u);
    for (std::size_t i = 1; i < stroke.points.size(); ++i) {
      length += (stroke.points[i] - stroke.points[i - 1]).norm();
    }
  }
  const BoundingBox box = bounding_box(surface.mesh);
  EXPECT_NEAR(length, 2 * (box.upper - box.lower).sum(), 0.2);  // two sides are in zigzag
  // A ring has no corner.
  EXPECT_EQ(feature_strokes(make_surface(make_shape("cylinder,resolution=40")), 40, 1, 1).size(),
            2u);
}

}  // namespace
}  // namespace brindle
