#include "brindle/local_positions.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace brindle {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

TEST(LocalPositions, StayWhereFloatsHoldThem) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(origin_near(Positions{}), Eigen::Vector3d::Zero());
  EXPECT_EQ(origin_near(Positions{{5e6, 1, 1}}), Eigen::Vector3d::Zero());
  EXPECT_EQ(origin_near(Positions{{nan, 1, 1}}), Eigen::Vector3d::Zero());
  EXPECT_EQ(origin_near(Positions{{0, 0, 0}, {1e9, 1, 1}}), Eigen::Vector3d::Zero());
  // The farthest coordinate just within 64 diagonals, and just beyond.
  EXPECT_EQ(origin_near(Positions{{63, 0, 0}, {64, 0, 0}}), Eigen::Vector3d::Zero());
  EXPECT_EQ(origin_near(Positions{{63.5, 0, 0}, {64.5, 0, 0}}), Eigen::Vector3d(64, 0, 0));
}

TEST(LocalPositions, AreMeasuredFromTheCentreOfWhatIsUsed) {
  const double far = std::numeric_limits<double>::infinity();
  const Positions positions = {
      {500000, 5800000, 12}, {500002, 5800004, 14}, {0, 0, 0}, {far, 5800000, 12}, {1e30, 0, 0}};
  const std::vector<char> used = {1, 1, 0, 1, 1};
  const Eigen::Vector3d origin = origin_near(positions, used);
  EXPECT_EQ(origin, Eigen::Vector3d(500001, 5800002, 13));
  EXPECT_EQ(origin_near(positions), Eigen::Vector3d::Zero());
  const std::vector<Vec3> local = positions_about(origin, positions);
  EXPECT_EQ(local[0], Vec3(-1, -2, -1));
  EXPECT_EQ(local[1], Vec3(1, 2, 1));
  EXPECT_EQ(placed(local[1], origin), positions[1]);
}

TEST(LocalPositions, AreSpokenOfOnlyIfTheyMoved) {
  EXPECT_EQ(describe_origin(Eigen::Vector3d::Zero()), "");
  EXPECT_NE(describe_origin({500000.25, 5800000, 1}).find("500000.25 5800000 1"),
            std::string::npos);
}

}  // namespace
}  // namespace brindle
