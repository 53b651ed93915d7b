#include "brindle/phases/coloring.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/base/random.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;

Index largest_degree(const Adjacency& adjacency) {
  Index degree = 0;
  for (Index i = 0; i < adjacency.node_count(); ++i) {
    degree = std::max(degree, static_cast<Index>(adjacency.of(i).size()));
  }
  return degree;
}

void expect_proper(const Coloring& coloring, const Adjacency& adjacency) {
  std::vector<std::size_t> uses(coloring.color_count);
  for (Index i = 0; i < adjacency.node_count(); ++i) {
    ASSERT_LT(coloring.color[i], coloring.color_count);
    ++uses[coloring.color[i]];
    for (const Index j : adjacency.of(i)) ASSERT_NE(coloring.color[i], coloring.color[j]);
  }
  EXPECT_EQ(std::ranges::count(uses, 0u), 0);
}

TEST(Coloring, NeighborsNeverShareAColor) {
  for (const char* shape :
       {"sphere,resolution=12", "sheets,resolution=10", "mobius,resolution=10"}) {
    const auto surface = wavy_surface(shape, Vec3(0, 1, 0.3f), 5);
    expect_proper(luby_coloring(*surface.neighborhood), *surface.neighborhood);
    expect_proper(greedy_coloring(*surface.neighborhood), *surface.neighborhood);
  }
}

TEST(Coloring, GreedyNeedsAtMostTheLargestDegreePlusOne) {
  const auto surface = wavy_surface("torus,resolution=60", Vec3(0, 1, 0), 5);
  EXPECT_LE(greedy_coloring(*surface.neighborhood).color_count,
            largest_degree(*surface.neighborhood) + 1);
}

TEST(Coloring, LastThirdOfLubysColorsHoldsFewNodes) {
  // The paper: about 1.5 % of the graph (section 4).
  const auto surface = wavy_surface("sphere,resolution=40", Vec3(0, 1, 0), 5);
  const Coloring coloring = luby_coloring(*surface.neighborhood);
  const Index first = coloring.color_count - coloring.color_count / 3;
  const auto last = std::ranges::count_if(coloring.color, [&](Index c) { return c >= first; });
  EXPECT_LT(static_cast<double>(last) / static_cast<double>(coloring.color.size()), 0.05);
}

TEST(Coloring, DoesNotDependOnTheNumberOfThreads) {
  const auto surface = wavy_surface("sphere,resolution=40", Vec3(0, 1, 0), 5);
  const ThreadLimit one(1);
  const Coloring alone = luby_coloring(*surface.neighborhood);
  const ThreadLimit two(2);
  EXPECT_EQ(luby_coloring(*surface.neighborhood).color, alone.color);
}

TEST(Coloring, LubysColorsDoNotTellTheRandomStart) {
  const auto surface = wavy_surface("sphere,resolution=40", Vec3(0, 1, 0), 5);
  const Coloring coloring = luby_coloring(*surface.neighborhood);
  std::complex<double> sum = 0;
  double count = 0;
  for (Index node = 0; node < coloring.color.size(); ++node) {
    if (coloring.color[node] != 0) continue;
    sum += std::complex<double>(random_phase(node));
    ++count;
  }
  EXPECT_LT(std::abs(sum) / count, 0.1);
}

TEST(OneAtATime, PhasesAreSpreadEvenly) {
  std::complex<double> sum = 0;
  for (Index node = 0; node < 10000; ++node) sum += std::complex<double>(random_phase(node));
  EXPECT_LT(std::abs(sum) / 10000, 0.03);
}

}  // namespace
}  // namespace brindle
