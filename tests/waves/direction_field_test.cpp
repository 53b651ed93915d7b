#include "brindle/direction_field.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "test_numbers.h"

namespace brindle {
namespace {

using testing_support::kNaN;

namespace fs = std::filesystem;

TEST(DirectionField, ProjectionIsAUnitTangentVector) {
  const std::vector<Vec3> normals{Vec3(1, 2, 3).normalized(), Vec3(0, 0, 1)};
  for (const Vec3& d : projected_direction_field(Vec3(5, 0, 1), normals)) {
    EXPECT_NEAR(d.norm(), 1, 1e-6);
  }
  EXPECT_NEAR(projected_direction_field(Vec3(5, 0, 1), normals)[0].dot(normals[0]), 0, 1e-6);
  EXPECT_LT((projected_direction_field(Vec3(5, 0, 1), normals)[1] - Vec3(1, 0, 0)).norm(), 1e-6);
}

TEST(DirectionField, HasNoWaveWhereTheVectorIsZeroOrNormalOrNotFinite) {
  const std::vector<Vec3> normals(4, Vec3(0, 0, 1));
  const std::vector<Vec3> vectors{Vec3(0, 0, 0), Vec3(0, 0, 2), Vec3(1, kNaN, 0),
                                  Vec3(std::numeric_limits<float>::infinity(), 0, 0)};
  for (const Vec3& d : tangent_directions(vectors, normals)) EXPECT_EQ(d, Vec3(0, 0, 0));
}

TEST(DirectionField, LengthOfVectorsDoesNotMatter) {
  const std::vector<Vec3> normals(2, Vec3(0, 0, 1));
  const auto d = tangent_directions(
      std::vector<Vec3>{Vec3(3e-20f, 4e-20f, 0), Vec3(3e15f, 4e15f, 0)}, normals);
  EXPECT_LT((d[0] - d[1]).norm(), 1e-6);
  EXPECT_NEAR(d[0].norm(), 1, 1e-6);
  const auto extreme = tangent_directions(
      std::vector<Vec3>{Vec3(3e-35f, 4e-35f, 0), Vec3(3e35f, 4e35f, 0)}, normals);
  for (const Vec3& e : extreme) EXPECT_LT((e - d[1]).norm(), 1e-5);
}

TEST(DirectionField, RefusesAZeroAxis) {
  EXPECT_THROW(projected_direction_field(Vec3::Zero(), std::vector<Vec3>{Vec3(0, 0, 1)}), Error);
  EXPECT_THROW(projected_direction_field(Vec3(kNaN, 0, 0), std::vector<Vec3>{Vec3(0, 0, 1)}),
               Error);
}

TEST(DirectionField, RotationIsCounterClockwiseAboutTheNormal) {
  const auto turned = rotated(std::vector<Vec3>{Vec3(1, 0, 0)}, std::vector<Vec3>{Vec3(0, 0, 1)},
                              static_cast<float>(M_PI / 2));
  EXPECT_LT((turned[0] - Vec3(0, 1, 0)).norm(), 1e-6);
}

}  // namespace
}  // namespace brindle
