#include "brindle/paths/path_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace brindle {
namespace {

Polylines scattered_lines(unsigned seed, int count, float size = 5) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(0, 100), way(-size, size);
  Polylines lines;
  for (int i = 0; i < count; ++i) {
    const Vec3 from(place(random), place(random), place(random));
    lines.add(from, Vec3::UnitZ());
    lines.add(from + Vec3(way(random), way(random), way(random)), Vec3::UnitZ());
    lines.end_line(false);
  }
  return lines;
}

Polylines ring_stack(int rings, int corners, float pitch) {
  Polylines lines;
  for (int r = 0; r < rings; ++r) {
    for (int i = 0; i < corners; ++i) {
      // Rings begin anywhere.
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i + 5 * r) /
                          static_cast<float>(corners);
      lines.add({std::cos(angle), std::sin(angle), pitch * static_cast<float>(r)}, Vec3::UnitZ());
    }
    lines.end_line(true);
  }
  return lines;
}

std::vector<Index> all_of(const Polylines& lines) {
  std::vector<Index> all(lines.count());
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

std::vector<PlacedLine> shortened(const Polylines& lines, const std::optional<Vec3>& start = {}) {
  std::vector<PlacedLine> order = nearest_order(lines, all_of(lines), start);
  shorten_travel(lines, order, start);
  return order;
}

/// The nearest end next, found among all.
double plain_greedy(const Polylines& lines, Vec3 from) {
  std::set<Index> left;
  for (const Index line : all_of(lines)) left.insert(line);
  double travel = 0;
  while (!left.empty()) {
    PlacedLine best;
    float least = std::numeric_limits<float>::infinity();
    for (const Index line : left) {
      for (const bool reversed : {false, true}) {
        const float way = (begin_of(lines, {line, reversed}) - from).norm();
        if (way < least) least = way, best = {line, reversed};
      }
    }
    travel += static_cast<double>(least);
    from = end_of(lines, best);
    left.erase(best.line);
  }
  return travel;
}

double least_travel(const Polylines& lines, const std::optional<Vec3>& start) {
  std::vector<Index> numbers = all_of(lines);
  double least = std::numeric_limits<double>::infinity();
  do {
    for (std::size_t turned = 0; turned < std::size_t{1} << numbers.size(); ++turned) {
      std::vector<PlacedLine> order;
      for (const Index line : numbers) order.push_back({line, (turned >> line & 1) != 0});
      least = std::min(least, travel_of(lines, order, start));
    }
  } while (std::next_permutation(numbers.begin(), numbers.end()));
  return least;
}

TEST(PathOrder, TravelsTheLeastPossibleWayBetweenAFewLines) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Polylines lines = scattered_lines(seed, 1 + static_cast<int>(seed % 6), 60);
    for (const auto& start : {std::optional<Vec3>(), std::optional<Vec3>(Vec3(0, 0, 0))}) {
      EXPECT_NEAR(travel_of(lines, shortened(lines, start), start), least_travel(lines, start),
                  1e-4);
    }
  }
}

TEST(PathOrder, NearestEndsComeNextAndShorteningNeverLengthens) {
  double nearest = 0, after = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Polylines lines = scattered_lines(seed, 300);
    const Vec3 start(0, 0, 0);
    std::vector<PlacedLine> order = nearest_order(lines, all_of(lines), start);
    const double before = travel_of(lines, order, start);
    EXPECT_NEAR(before, plain_greedy(lines, start), 1e-2);
    shorten_travel(lines, order, start);
    EXPECT_LE(travel_of(lines, order, start), before);
    std::set<Index> once;
    for (const PlacedLine& placed : order) once.insert(placed.line);
    EXPECT_EQ(once.size(), lines.count());
    nearest += before;
    after += travel_of(lines, order, start);
  }
  EXPECT_LT(after, 0.9 * nearest);
}

TEST(PathOrder, ClosedLinesBeginWhereTravelIsLeast) {
  for (const int rings : {2, 7, 40}) {
    const Polylines lines = ring_stack(rings, 60, 0.1f);
    EXPECT_NEAR(travel_of(lines, shortened(lines)), 0.1 * (rings - 1), 1e-4) << rings;
  }
}

TEST(PathOrder, LinesBesideComeFirst) {
  // The end of line 2 is nearer to that of line 0 than line 1, which is beside it.
  Polylines lines;
  for (const auto& [x, y] : {std::pair(0.0f, 1.0f), {1.5f, 3.0f}, {4.0f, 1.2f}}) {
    lines.add({x, 0, 0}, Vec3::UnitZ());
    lines.add({y, 0, 0}, Vec3::UnitZ());
    lines.end_line(false);
  }
  const auto numbers = [&](const LinesBeside& beside) {
    std::vector<Index> result;
    for (const PlacedLine& placed : nearest_order(lines, all_of(lines), Vec3(0, 0, 0), beside)) {
      result.push_back(placed.line);
    }
    return result;
  };
  EXPECT_EQ(numbers({}), (std::vector<Index>{0, 2, 1}));
  EXPECT_EQ(numbers({{1}, {0}, {}}), (std::vector<Index>{0, 1, 2}));
}

TEST(PathOrder, ReversedLinesMotionAndScaleChangeNothing) {
  const Polylines lines = scattered_lines(3, 200);
  Polylines turned, moved = lines;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    for (const std::size_t i : {1u, 0u}) turned.add(lines.points_of(line)[i], Vec3::UnitZ());
    turned.end_line(false);
  }
  const Eigen::Matrix3f rotation =
      Eigen::AngleAxisf(1.1f, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& point : moved.points) point = 3 * (rotation * point) + Vec3(5, -2, 9);
  const double travel = travel_of(lines, shortened(lines));
  EXPECT_NEAR(travel_of(turned, shortened(turned)), travel, 1e-3);
  EXPECT_NEAR(travel_of(moved, shortened(moved)), 3 * travel, 0.02 * travel);
}

TEST(PathOrder, CancelsAndTakesNothing) {
  EXPECT_TRUE(nearest_order({}, {}).empty());
  const Polylines lines = scattered_lines(1, 2000);
  std::vector<PlacedLine> order = nearest_order(lines, all_of(lines));
  int reports = 0;
  const Progress cancelling([&](std::string_view, double) { return ++reports < 3; });
  EXPECT_THROW(shorten_travel(lines, order, {}, cancelling), Cancelled);
  EXPECT_EQ(reports, 3);
}

}  // namespace
}  // namespace brindle
