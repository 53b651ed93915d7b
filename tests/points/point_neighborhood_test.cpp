#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/points.h"
#include "test_points.h"

namespace brindle {
namespace {

using testing_support::random_points;

std::vector<Index> all_of(const std::vector<Vec3>& points) {
  std::vector<Index> used(points.size());
  std::iota(used.begin(), used.end(), Index{0});
  return used;
}

#ifdef BRINDLE_HAS_NANOFLANN

TEST(PointNeighborhood, MoreThanMemoryHoldsAreRefusedByName) {
  const std::vector<Vec3> points = random_points(3000);
  const std::vector<Index> used = all_of(points);
  const AssumedMemory little(6e6);  // half of it for 150 000 neighbours of 20 bytes
  try {
    point_neighborhood(points, used, 1000);
    FAIL();
  } catch (const TooLarge& error) {
    EXPECT_NE(std::string(error.what())
                  .find("1000 neighbours of each of 3000 points would be 3e+06 neighbours"),
              std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("30 each would do"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(point_neighborhood(points, used, 30).node_count(), points.size());
}

TEST(PointNeighborhood, JoinsTheNearestBothWays) {
  const std::vector<Vec3> points = random_points(300);
  const std::vector<Index> used = all_of(points);
  constexpr std::size_t kCount = 5;
  std::vector<std::vector<Index>> nearest(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    std::vector<Index> others = used;
    others.erase(others.begin() + i);
    std::ranges::sort(others, {}, [&](Index j) { return (points[i] - points[j]).squaredNorm(); });
    nearest[i].assign(others.begin(), others.begin() + kCount);
  }
  const auto near = [&](Index i, Index j) {
    return std::ranges::find(nearest[i], j) != nearest[i].end();
  };
  const Adjacency neighborhood = point_neighborhood(points, used, kCount);
  for (Index i = 0; i < points.size(); ++i) {
    std::vector<Index> expected;
    for (Index j = 0; j < points.size(); ++j) {
      if (near(i, j) || near(j, i)) expected.push_back(j);
    }
    EXPECT_TRUE(std::ranges::equal(neighborhood.of(i), expected)) << i;
  }
}

TEST(PointNeighborhood, LeavesOutWhatIsNotUsed) {
  const std::vector<Vec3> points = random_points(50);
  const std::vector<Index> used = {3, 4, 9, 20, 41};
  const Adjacency neighborhood = point_neighborhood(points, used, 2);
  EXPECT_EQ(neighborhood.node_count(), 50u);
  for (Index i = 0; i < 50; ++i) {
    const bool is_used = std::ranges::find(used, i) != used.end();
    EXPECT_EQ(neighborhood.of(i).empty(), !is_used);
    for (const Index j : neighborhood.of(i)) {
      EXPECT_NE(std::ranges::find(used, j), used.end());
    }
  }
}

TEST(PointNeighborhood, OfFewPointsJoinsAllToAll) {
  EXPECT_EQ(point_neighborhood(random_points(0), {}, 8).node_count(), 0u);
  for (std::size_t count = 1; count <= 5; ++count) {
    const std::vector<Vec3> points = random_points(count);
    const Adjacency neighborhood = point_neighborhood(points, all_of(points), 8);
    EXPECT_EQ(neighborhood.directed_edge_count(), count * (count - 1));
  }
}

TEST(PointNeighborhood, IsTheSameForOneAndTwoThreads) {
  const std::vector<Vec3> points = random_points(5000);
  const ThreadLimit two(2);
  const Adjacency together = point_neighborhood(points, all_of(points), 8);
  const ThreadLimit one(1);
  const Adjacency alone = point_neighborhood(points, all_of(points), 8);
  EXPECT_EQ(together.offsets, alone.offsets);
  EXPECT_EQ(together.neighbors, alone.neighbors);
}

#else

TEST(PointNeighborhood, SaysWhatItNeeds) {
  const std::vector<Vec3> points = random_points(5);
  EXPECT_THROW(point_neighborhood(points, all_of(points), 2), Error);
}

#endif

TEST(PointNeighborhood, RefusesACountBelowOne) {
  const std::vector<Vec3> points = random_points(5);
  EXPECT_THROW(point_neighborhood(points, all_of(points), 0), Error);
}

}  // namespace
}  // namespace brindle
