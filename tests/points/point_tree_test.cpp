#include "brindle/points/point_tree.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "test_points.h"

namespace brindle {
namespace {

using testing_support::random_points;

/// The numbers of all points, the nearest to `point` first.
std::vector<Index> by_distance(const std::vector<Vec3>& points, const Vec3& point) {
  std::vector<Index> numbers(points.size());
  std::iota(numbers.begin(), numbers.end(), Index{0});
  std::ranges::sort(numbers, {}, [&](Index i) { return (points[i] - point).squaredNorm(); });
  return numbers;
}

TEST(PointTree, FindsWhatALookAtAllPointsFinds) {
  const std::vector<Vec3> points = random_points(400);
  if (!has_point_trees()) {
    EXPECT_THROW(PointTree tree(points), Error);
    return;
  }
  const PointTree tree(points);
  std::vector<Index> found;
  for (const Vec3& point : random_points(20)) {
    std::vector<Index> expected = by_distance(points, point);
    tree.nearest(point, 7, found);
    EXPECT_EQ(found, std::vector<Index>(expected.begin(), expected.begin() + 7));
    std::erase_if(expected, [&](Index i) { return (points[i] - point).norm() >= 0.3f; });
    tree.within(point, 0.3f, found);
    EXPECT_EQ(found, expected);
  }
}

TEST(PointTree, OfFewPointsOrNoneFindsWhatThereIs) {
  if (!has_point_trees()) GTEST_SKIP() << "this build has no nanoflann";
  std::vector<Index> found = {1, 2, 3};
  const std::vector<Vec3> none;
  PointTree(none).nearest(Vec3::Zero(), 5, found);
  EXPECT_TRUE(found.empty());
  const std::vector<Vec3> three = random_points(3);
  const PointTree tree(three);
  tree.nearest(Vec3::Zero(), 5, found);
  EXPECT_EQ(found, by_distance(three, Vec3::Zero()));
  tree.nearest(Vec3::Zero(), 0, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace brindle
