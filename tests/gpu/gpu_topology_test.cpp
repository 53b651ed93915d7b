#include "brindle/gpu/gpu_topology.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "brindle/phases/multilevel.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;

/// The slot whose row has an entry.
Index row_of(const SlicedLayout& layout, std::size_t entry) {
  const auto column = static_cast<Index>(entry / kLanes);
  const auto slice = std::ranges::upper_bound(layout.column_begin, column) - 1;
  return static_cast<Index>((slice - layout.column_begin.begin()) * kLanes + entry % kLanes);
}

struct FlatHierarchyTest : testing::Test {
  Hierarchy hierarchy =
      build_hierarchy(wavy_surface("torus,resolution=100", Vec3(0.31f, 0.9f, 0.27f), 25).graph());
  std::vector<LevelTopology> topologies;
  FlatHierarchy flat;

  void SetUp() override {
    for (const Level& level : hierarchy.levels) topologies.push_back(level.topology);
    flat = flatten(topologies, 2);
    ASSERT_GT(flat.levels.size(), 3u);
  }
  std::uint32_t word(std::uint32_t place) const { return flat.topology.at(place); }
};

TEST_F(FlatHierarchyTest, LevelsFollowEachOtherWithoutGaps) {
  std::uint32_t slots = 0, columns = 0;
  for (std::size_t l = 0; l < flat.levels.size(); ++l) {
    const SlicedLayout& layout = *topologies[l].layout;
    EXPECT_EQ(flat.levels[l].first_slot, slots);
    EXPECT_EQ(flat.levels[l].first_column, columns);
    slots += layout.slot_count();
    columns += static_cast<std::uint32_t>(layout.entry_count() / kLanes);
  }
  EXPECT_EQ(flat.slot_count, slots);
  EXPECT_EQ(flat.neighbors.size(), std::size_t{columns} * kLanes);
}

TEST_F(FlatHierarchyTest, EveryRowHasItsNeighbours) {
  for (std::size_t l = 0; l < flat.levels.size(); ++l) {
    const FlatLevel& level = flat.levels[l];
    const SlicedLayout& layout = *topologies[l].layout;
    for (Index slot = 0; slot < layout.slot_count(); ++slot) {
      const std::uint32_t first = word(level.columns + slot / kLanes) * kLanes + slot % kLanes;
      ASSERT_EQ(word(level.columns + slot / kLanes + 1) * kLanes + slot % kLanes,
                first + layout.width(slot) * kLanes);
      for (Index k = 0; k < layout.width(slot); ++k) {
        ASSERT_EQ(flat.neighbors.at(first + k * kLanes),
                  level.first_slot + layout.neighbor[layout.first_entry(slot) + k * kLanes]);
      }
    }
  }
}

TEST_F(FlatHierarchyTest, ColorsHoldEverySliceOnce) {
  for (const FlatLevel& level : flat.levels) {
    std::set<std::uint32_t> slices;
    for (std::uint32_t n = word(level.color_begin); n < word(level.color_begin + level.color_count);
         n += 3) {
      EXPECT_TRUE(slices.insert(word(n)).second);
      EXPECT_EQ(word(n + 1), word(level.columns + word(n)));
      EXPECT_EQ(word(n + 2), word(level.columns + word(n) + 1));
    }
    EXPECT_EQ(slices.size(), level.slot_count / kLanes);
  }
}

TEST_F(FlatHierarchyTest, MembersAndTheirGaugeEntriesAreThoseOfTheAggregation) {
  const FlatLevel& fine = flat.levels[0];
  const Aggregation& aggregation = *topologies[0].aggregation;
  for (std::uint32_t a = 0; a + 1 < aggregation.member_begin.size(); ++a) {
    std::set<std::uint32_t> before;
    for (std::uint32_t m = word(fine.member_begin + a); m < word(fine.member_begin + a + 1);
         m += 2) {
      const std::uint32_t slot = word(m);
      ASSERT_EQ(word(fine.coarse_slots + slot), flat.levels[1].first_slot + a);
      // All couplings that lead back into the aggregate, and nothing else.
      std::size_t entries = 0;
      for (std::uint32_t e = word(m + 1); e < word(m + 3); e += 2, ++entries) {
        ASSERT_TRUE(before.contains(word(e + 1)));
        ASSERT_EQ(flat.neighbors.at(word(e)), word(e + 1));
      }
      ASSERT_EQ(entries > 0, !before.empty());
      before.insert(slot);
    }
    ASSERT_EQ(before.size(), aggregation.member_begin[a + 1] - aggregation.member_begin[a]);
  }
}

TEST_F(FlatHierarchyTest, EveryCouplingBetweenAggregatesAddsToTheirsOnce) {
  const SlicedLayout& fine = *topologies[0].layout;
  const SlicedLayout& coarse = *topologies[1].layout;
  const std::vector<Index>& coarse_slot = topologies[0].aggregation->coarse_slot;
  std::set<std::uint32_t> seen;
  for (Index slot = 0; slot < coarse.slot_count(); ++slot) {
    for (Index k = 0; k < coarse.width(slot); ++k) {
      const auto entry = static_cast<Index>(coarse.first_entry(slot) + k * kLanes);
      const std::uint32_t rounds = flat.levels[0].source_begin + entry / kLanes;
      for (std::uint32_t r = word(rounds); r < word(rounds + 1); r += kLanes) {
        const std::uint32_t source = word(r + entry % kLanes);
        if (source == kNone) continue;
        ASSERT_TRUE(seen.insert(source).second);
        ASSERT_EQ(coarse_slot[row_of(fine, source)], slot);
        ASSERT_EQ(coarse_slot[fine.neighbor[source]], coarse.neighbor[entry]);
      }
    }
  }
  std::size_t between = 0;
  for (std::size_t entry = 0; entry < fine.entry_count(); ++entry) {
    const Index i = coarse_slot[row_of(fine, entry)], j = coarse_slot[fine.neighbor[entry]];
    between += i != j && i != coarse.slot_count() && j != coarse.slot_count();
  }
  EXPECT_EQ(seen.size(), between);
}

TEST_F(FlatHierarchyTest, NodesAndSweepsAreThoseOfTheProcessor) {
  const SlicedLayout& finest = *topologies[0].layout;
  for (Index slot = 0; slot < finest.slot_count(); ++slot) {
    ASSERT_EQ(word(flat.node_at + slot), finest.node_at[slot]);
  }
  for (const FlatLevel& level : flat.levels) {
    const LevelSweeps planned = SweepPlan(2).on_level(level.slot_count);
    EXPECT_EQ(level.planned_sweeps().count, planned.count);
    EXPECT_EQ(level.planned_sweeps().over_relaxation, planned.over_relaxation);
  }
}

}  // namespace
}  // namespace brindle
