#include "brindle/phases/several_starts.h"

#include <vector>

#include <gtest/gtest.h>

#include "brindle/phases/multilevel.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"
#include "brindle/threads.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

PhaseGraph direction_graph(const char* shape, int symmetry = 2) {
  const Surface surface = make_surface(make_shape(shape));
  return build_direction_graph(surface.neighborhood, surface.normals, symmetry);
}

double lowered_of(const PhaseGraph& graph, bool from_several, int sweeps = 4) {
  Hierarchy hierarchy = build_hierarchy(graph);
  if (from_several) {
    descend_from_several(hierarchy, sweeps);
  } else {
    descend(hierarchy, sweeps);
  }
  const EnergySums sums = lowered_sums(hierarchy.levels[0], hierarchy.levels[0].z);
  return sums.energy / sums.weight;
}

/// A torus has fields without singularities; one start ends in one with some, and four times the
/// energy or more.
TEST(SeveralStarts, FindTheSmoothestFieldOfATorus) {
  for (const char* torus :
       {"torus,resolution=64", "torus,resolution=100", "torus,resolution=200"}) {
    const PhaseGraph graph = direction_graph(torus);
    EXPECT_LT(lowered_of(graph, true), 0.6 * lowered_of(graph, false)) << torus;
  }
}

TEST(SeveralStarts, AreNeverHigherThanOne) {
  for (const char* shape : {"trefoil,resolution=30", "sphere,resolution=16", "box,resolution=20",
                            "mobius,resolution=16"}) {
    for (const int symmetry : {1, 2, 4}) {
      const PhaseGraph graph = direction_graph(shape, symmetry);
      EXPECT_LE(lowered_of(graph, true), lowered_of(graph, false)) << shape << " " << symmetry;
    }
  }
}

/// What is hardly lower is not taken: surfaces that hardly differ have the same field.
TEST(SeveralStarts, KeepThePhasesOfOneUnlessOthersAreMuchLower) {
  const PhaseGraph graph = direction_graph("trefoil,resolution=40");
  Hierarchy one = build_hierarchy(graph), several = build_hierarchy(graph);
  descend(one, 2);
  EXPECT_FALSE(descend_from_several(several, 2));
  EXPECT_EQ(one.levels[0].z, several.levels[0].z);
}

TEST(SeveralStarts, AreMuchLowerByATenth) {
  EXPECT_TRUE(is_much_lower({0.89, 10}, {1, 10}));
  EXPECT_FALSE(is_much_lower({0.91, 10}, {1, 10}));
  EXPECT_FALSE(is_much_lower({0, 10}, {1e-6, 10})) << "rounding";
}

TEST(SeveralStarts, AreTheSameOnAnyNumberOfThreads) {
  const PhaseGraph graph = direction_graph("torus,resolution=100");
  std::vector<LowestPhases> found;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    found.push_back(solve_from(Starts::several, graph, 4, 2));
  }
  EXPECT_TRUE(found[0].is_lower);
  EXPECT_EQ(found[0].z, found[1].z);
  EXPECT_EQ(found[0].z, found[2].z);
}

/// An anchor counts as an edge does: phases along it add nothing, against it twice its length.
TEST(SeveralStarts, CountWhatAnchorsAdd) {
  PhaseGraph graph = direction_graph("plane,resolution=8");
  graph.anchor.assign(graph.node_count(), Complex(0));
  graph.anchor[3] = {0, 2};
  graph.anchor[5] = {0, -1};
  Hierarchy hierarchy = finest_level(*graph.adjacency);
  Level& level = hierarchy.levels[0];
  load_couplings(graph, level.layout(), level.couplings);
  const std::vector<Complex> peaks(level.layout().slot_count() + 1, kPeak);
  const EnergySums edges = energy_sums(level.layout(), level.couplings, peaks);
  const EnergySums all = lowered_sums(level, peaks);
  EXPECT_NEAR(all.energy - edges.energy, 2, 1e-6);
  EXPECT_EQ(all.weight, edges.weight);
}

}  // namespace
}  // namespace brindle
