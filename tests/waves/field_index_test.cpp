
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Directions at the corners of a triangle in the plane, at these angles.
std::array<Vec3, 3> at_angles(float a, float b, float c) {
  const auto direction = [](float angle) { return Vec3(std::cos(angle), std::sin(angle), 0); };
  return {direction(a), direction(b), direction(c)};
}

TEST(FieldIndex, CountsTurnsOfEverySymmetry) {
  const Vec3 up(0, 0, 3);
  for (const int symmetry : {1, 2, 4}) {
    const float turn = 2 * kPi / static_cast<float>(symmetry);
    EXPECT_EQ(field_index(up, at_angles(0.1f, 0.3f, -0.2f), symmetry), 0);
    EXPECT_EQ(field_index(up, at_angles(0, turn / 3, 2 * turn / 3), symmetry), 1);
    EXPECT_EQ(field_index(up, at_angles(0, -turn / 3, -2 * turn / 3), symmetry), -1);
    // From below, all is the other way round.
    EXPECT_EQ(field_index(-up, at_angles(0, turn / 3, 2 * turn / 3), symmetry), -1);
  }
}

TEST(FieldIndex, DoesNotDependOnWhichOfTheDirectionsIsNamed) {
  const Vec3 up(0, 0, 1);
  const std::array<Vec3, 3> d = at_angles(0, kPi / 3, 2 * kPi / 3);
  EXPECT_EQ(field_index(up, d, 2), 1);
  EXPECT_EQ(field_index(up, {d[0], -d[1], d[2]}, 2), 1);
  EXPECT_EQ(field_index(up, {-d[0], d[1], -d[2]}, 2), 1);
}

/// The angle of a place seen from the middle, over N: the simplest singularity that there is.
TEST(FieldIndex, CountsTrianglesOfAField) {
  const Surface plane = make_surface(make_shape("plane,resolution=31"));
  for (const int symmetry : {1, 2, 4}) {
    DirectionField around;
    for (const Vec3& p : plane.mesh.positions) {
      const float angle = std::atan2(p.y() - 0.0172f, p.x() - 0.0131f);
      around.push_back(at_angles(angle / static_cast<float>(symmetry), 0, 0)[0]);
    }
    EXPECT_EQ(count_singularities(plane.mesh, around, symmetry), 1u) << symmetry;
  }
  const DirectionField parallel(plane.normals.size(), Vec3(1, 0, 0));
  EXPECT_EQ(count_singularities(plane.mesh, parallel, 2), 0u);
  // Where a corner has no direction, nothing is known.
  const DirectionField none(plane.normals.size(), Vec3::Zero());
  EXPECT_EQ(count_singularities(plane.mesh, none, 2), 0u);
}

}  // namespace
}  // namespace brindle
