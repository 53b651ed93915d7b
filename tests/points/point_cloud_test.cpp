#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/points.h"

namespace brindle {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(PointCloud, SetsAsideWhatIsNotFiniteOrRepeated) {
  const LoadedPoints loaded = make_point_cloud(
      {{1, 0, 0}, {kNan, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1e30f, 0}, {-0.0f, 1, 0}});
  EXPECT_EQ(loaded.repair, (PointRepair{.not_finite = 2, .repeated = 2}));
  EXPECT_EQ(loaded.cloud.used, (std::vector<Index>{0, 2}));
  ASSERT_EQ(loaded.cloud.positions.size(), 6u);
  for (const Vec3& position : loaded.cloud.positions) EXPECT_TRUE(position.allFinite());
}

TEST(PointCloud, MakesNormalsUnitVectors) {
  const LoadedPoints loaded =
      make_point_cloud({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1e-30f}, {0, 3e30f, 0}});
  EXPECT_EQ(loaded.repair, PointRepair());
  EXPECT_LT((loaded.cloud.normals[0] - Vec3(0, 0, 1)).norm(), 1e-5);
  EXPECT_LT((loaded.cloud.normals[1] - Vec3(0, 1, 0)).norm(), 1e-5);
}

TEST(PointCloud, DropsAllNormalsIfOneIsMissing) {
  const LoadedPoints loaded = make_point_cloud({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, kNan, 0}});
  EXPECT_TRUE(loaded.cloud.normals.empty());
  EXPECT_EQ(loaded.repair.without_normal, 1u);
  // That of a point which is set aside does not matter.
  EXPECT_EQ(make_point_cloud({{0, 0, 0}, {0, 0, 0}}, {{0, 0, 1}, {0, 0, 0}}).cloud.normals.size(),
            2u);
}

TEST(PointCloud, RefusesAnotherNumberOfNormals) {
  EXPECT_THROW(make_point_cloud({{0, 0, 0}}, {{0, 0, 1}, {0, 0, 1}}), Error);
}

TEST(PointCloud, FindingsAreDescribedLineByLine) {
  EXPECT_EQ(describe(PointRepair()), "");
  const std::string text = describe(PointRepair{1, 2, 3});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

}  // namespace
}  // namespace brindle
