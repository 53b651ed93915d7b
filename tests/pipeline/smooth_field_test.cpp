#include "brindle/pipeline/smooth_field.h"

#include <cmath>

#include <gtest/gtest.h>

#include "brindle/base/error.h"
#include "brindle/base/parallel.h"
#include "brindle/surface/shapes.h"

namespace brindle {
namespace {

/// Triangles whose three directions cannot be oriented alike.
std::size_t singularities(const Surface& surface, const DirectionField& field) {
  std::size_t count = 0;
  for (const Triangle& t : surface.mesh.triangles) {
    count +=
        field[t[0]].dot(field[t[1]]) * field[t[1]].dot(field[t[2]]) * field[t[2]].dot(field[t[0]]) <
        0;
  }
  return count;
}

TEST(SmoothField, IsConstantOnAPlane) {
  const Surface plane = make_surface(make_shape("plane,resolution=40"));
  const DirectionField field = smooth_direction_field(plane);
  for (const Vec3& d : field) EXPECT_NEAR(std::abs(d.dot(field[0])), 1, 1e-4);
}

TEST(SmoothField, IsTangentAndUnit) {
  const Surface surface = make_surface(make_shape("torus,resolution=60"));
  const DirectionField field = smooth_direction_field(surface);
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_NEAR(field[i].norm(), 1, 1e-5);
    EXPECT_NEAR(field[i].dot(surface.normals[i]), 0, 1e-5);
  }
}

TEST(SmoothField, LineFieldOnASphereHasAtLeastFourSingularitiesAndFewMore) {
  // Each counts one half; they sum to the Euler characteristic, 2.
  const Surface sphere = make_surface(make_shape("sphere,resolution=20"));
  const std::size_t count = singularities(sphere, smooth_direction_field(sphere));
  EXPECT_GE(count, 4u);
  EXPECT_LE(count, 12u);
  EXPECT_EQ(count % 2, 0u);
}

TEST(SmoothField, OnATorusHasHardlyASingularity) {
  // Their indices sum to the Euler characteristic, 0: they come in pairs.
  const Surface torus = make_surface(make_shape("torus,resolution=80"));
  const std::size_t count = singularities(torus, smooth_direction_field(torus));
  EXPECT_LE(count, 4u);
  EXPECT_EQ(count % 2, 0u);
}

TEST(SmoothField, CrossesTheSeamOfAMobiusStrip) {
  const Surface mobius = make_surface(make_shape("mobius,resolution=12"));
  EXPECT_EQ(singularities(mobius, smooth_direction_field(mobius)), 0u);
}

TEST(SmoothField, FollowsCurvatureWhereItIsAnchored) {
  const Surface cylinder = make_surface(make_shape("cylinder,resolution=60"));
  SmoothFieldOptions options;
  options.curvature_anchor = 1;
  for (const Vec3& d : smooth_direction_field(cylinder, options)) {
    EXPECT_LT(std::abs(d.z()), 0.05) << "the larger curvature runs around";
  }
  options.curvature_direction = CurvatureDirection::minimum;
  for (const Vec3& d : smooth_direction_field(cylinder, options)) {
    EXPECT_GT(std::abs(d.z()), 0.99) << "the smaller runs along";
  }
}

TEST(SmoothField, IsTheSameForEveryNumberOfThreads) {
  const Surface surface = make_surface(make_shape("sphere,resolution=30"));
  const ThreadLimit one(1);
  const DirectionField alone = smooth_direction_field(surface);
  const ThreadLimit two(2);
  EXPECT_EQ(smooth_direction_field(surface), alone);
}

TEST(SmoothField, RefusesASymmetryBelowOne) {
  SmoothFieldOptions options;
  options.symmetry = 0;
  EXPECT_THROW(smooth_direction_field(make_surface(make_shape("plane,resolution=4")), options),
               Error);
}

}  // namespace
}  // namespace brindle
