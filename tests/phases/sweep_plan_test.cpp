#include <algorithm>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/frequency_field.h"
#include "brindle/phases/multilevel.h"
#include "brindle/shapes.h"
#include "brindle/solver.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

TEST(SweepPlan, OfGraphsThatAreNotLargeIsThatOfFrames) {
  for (const Index finest : {Index{100}, kSmallLevel, kLargeLevel - 1}) {
    for (Index slots = finest; slots > 0; slots /= 4) {
      const LevelSweeps frame = SweepPlan(2).on_level(slots);
      const LevelSweeps first = SweepPlan::for_new_levels(2, finest).on_level(slots);
      EXPECT_EQ(first.count, frame.count) << slots;
      EXPECT_EQ(first.over_relaxation, frame.over_relaxation) << slots;
    }
  }
}

TEST(SweepPlan, OfLargeGraphsGrowsFromLevelToLevel) {
  constexpr Index kFinest = 16 * kLargeLevel;
  const SweepPlan plan = SweepPlan::for_new_levels(2, kFinest);
  EXPECT_EQ(plan.on_level(kFinest).count, 6);
  EXPECT_EQ(plan.on_level(kFinest / 4).count, 12);
  EXPECT_EQ(plan.on_level(kFinest / 16).count, 24);
  EXPECT_EQ(plan.on_level(kSmallLevel / 2).count, SweepPlan(2).on_level(kSmallLevel / 2).count);
  // All over-relax but the last, whatever the level.
  EXPECT_GT(plan.on_level(kFinest).over_relaxation_of(0), 1);
  EXPECT_EQ(plan.on_level(kFinest).over_relaxation_of(5), 1);
  EXPECT_EQ(SweepPlan::for_new_levels(0, kLargeLevel).on_level(kLargeLevel).count, 0);
}

/// A torus of 143,360 vertices.
TEST(SweepPlan, LeavesLittleForCyclesOnLargeSurfaces) {
  const Surface surface = make_surface(make_shape("torus,resolution=512"));
  const WaveSet waves{
      surface.mesh.positions, projected_direction_field({0.31f, 0.9f, 0.27f}, surface.normals),
      constant_frequency_field(frequency_of_stripes(40, bounding_box(surface.mesh).diagonal()),
                               surface.mesh.vertex_count())};
  const PhaseGraph graph = build_phase_graph(surface.neighborhood, waves);
  ASSERT_GE(graph.node_count(), kLargeLevel);
  const double once = solve_phases(graph).energy;
  Hierarchy hierarchy = build_hierarchy(graph);
  const Level& finest = hierarchy.levels[0];
  descend(hierarchy, 2);
  const double of_frame = energy(graph, to_nodes(finest.layout(), finest.z));
  run_cycles(hierarchy, 2, 4, {});
  const double of_cycles = energy(graph, to_nodes(finest.layout(), finest.z));
  EXPECT_LT(once, 1.01 * of_cycles);
  EXPECT_GT(of_frame, 1.03 * of_cycles);
}

}  // namespace
}  // namespace brindle
