#include "brindle/distributed/levels/rank_graph.h"

#include <gtest/gtest.h>

#include "brindle/distributed/surface/rank_surface.h"
#include "ranks.h"

namespace brindle {
namespace {

using namespace testing_support;

TEST(RankColoring, ColoursNoNeighboursAlikeAcrossRanks) {
  const auto whole = wavy_surface("molecule,resolution=30", kAxis, 20);
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const DistributedSurface surface = Parts(whole, cut.rank_of_triangle(whole.mesh)).surface();
    const RankGraph& graph = surface.rank_surface().graph;
    Communicator& ranks = *surface.rank_surface().ranks;
    const Coloring coloring = rank_coloring(ranks, graph);
    for (Index node = 0; node < graph.own; ++node) {
      for (const Index other : graph.adjacency->of(node)) {
        ASSERT_NE(coloring.color[node], coloring.color[other]);
      }
    }
    // Ghosts have their owners' colours.
    std::vector<Index> colors = coloring.color;
    exchange(ranks, graph.halo, std::span(colors));
    EXPECT_EQ(colors, coloring.color);
    if (rank_count() == 1) {
      EXPECT_EQ(coloring.color, greedy_coloring(*whole.neighborhood).color);
    }
  }
}

TEST(HilbertPlace, NeighboursOnTheCurveAreNeighboursInSpace) {
  // The first 8^4 cells of the curve fill a cube of 16 cells an edge.
  std::vector<std::array<int, 3>> at(16 * 16 * 16, {-1, -1, -1});
  for (int x = 0; x < 16; ++x) {
    for (int y = 0; y < 16; ++y) {
      for (int z = 0; z < 16; ++z) {
        const std::uint64_t place =
            hilbert_place({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                           static_cast<std::uint32_t>(z)});
        ASSERT_LT(place, at.size());
        at[place] = {x, y, z};
      }
    }
  }
  for (std::size_t n = 1; n < at.size(); ++n) {
    int steps = 0;
    for (std::size_t k = 0; k < 3; ++k) steps += std::abs(at[n][k] - at[n - 1][k]);
    ASSERT_EQ(steps, 1);
  }
}

}  // namespace
}  // namespace brindle
