#include "gallery/implicit.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "brindle/base/random.h"
#include "brindle/shapes/parametric_shapes.h"
#include "gallery/hare.h"
#include "gallery/liver.h"
#include "parametric_meshes.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

TEST(LevelCurvature, OfASphereATubeAndAnEllipsoidIsExact) {
  const ImplicitFunction sphere = limb({0, 0, 0}, {0, 0, 0}, 2, 2);
  const LevelCurvature round = level_curvature(sphere, Point(1.2, 1.6, 0), 1e-3);
  EXPECT_NEAR(round.larger, 0.5, 1e-5);
  EXPECT_NEAR(round.smaller, 0.5, 1e-5);
  EXPECT_NEAR(round.normal.dot(Point(0.6, 0.8, 0)), 1, 1e-9);
  const ImplicitFunction tube = limb({0, 0, -5}, {0, 0, 5}, 2, 2);
  const LevelCurvature bent = level_curvature(tube, Point(0, 2, 0), 1e-3);
  EXPECT_NEAR(bent.larger, 0.5, 1e-5);
  EXPECT_NEAR(bent.smaller, 0, 1e-5);
  EXPECT_NEAR(std::abs(bent.larger_direction.x()), 1, 1e-6);
  EXPECT_NEAR(std::abs(bent.smaller_direction.z()), 1, 1e-6);
  // At the end of the axis a: a / b^2 and a / c^2.
  const LevelCurvature tip = level_curvature(ellipsoid({0, 0, 0}, {3, 2, 1}), Point(3, 0, 0), 1e-3);
  EXPECT_NEAR(tip.larger, 3, 1e-4);
  EXPECT_NEAR(tip.smaller, 0.75, 1e-4);
}

// What `isosurface` needs of a function so that it loses nothing.
TEST(ImplicitFunctions, AreNowhereSteeperThanOne) {
  for (const ImplicitFunction& function : {hare(), liver_hull(), liver_tumour()}) {
    std::uint64_t drawn = 0;
    for (int i = 0; i < 3000; ++i) {
      Point p, step;
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = 100 * (2 * random_number(4, drawn++) - 1) * (i % 2 == 0 ? 1 : 0.025);
        step[axis] = 0.3 * (2 * random_number(4, drawn++) - 1);
      }
      EXPECT_LE(std::abs(function(p + step) - function(p)), step.norm() * (1 + 1e-9));
    }
  }
}

TEST(CutOpen, LeavesARimInThePlane) {
  Mesh mesh = make_sphere({.radius = 1, .resolution = 10});
  const std::size_t before = mesh.triangle_count();
  cut_open(mesh, {0, 0, 0.4}, {0, 0, 1}, 2);
  EXPECT_LT(mesh.triangle_count(), before);
  float highest = -1;
  for (const Vec3& p : mesh.positions) highest = std::max(highest, p.z());
  EXPECT_NEAR(highest, 0.4f, 1e-6f);
}

}  // namespace
}  // namespace brindle
