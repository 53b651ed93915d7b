#include "brindle/phases/hierarchy.h"

#include <random>

#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/phases/multilevel.h"
#include "reflecting_graph.h"

#ifdef BRINDLE_HAS_TBB
#include <tbb/task_arena.h>
#endif

namespace brindle {
namespace {

using testing_support::reflecting_graph;
using testing_support::wavy_surface;

/// sum_i Re(conj(z_i) t_i) over the entries of a level and, twice, over its anchors: what the
/// energy is lowered by.
double agreement(const Level& level) {
  double sum = 0;
  for (Index slot = 0; slot < level.layout().slot_count(); ++slot) {
    if (level.layout().node_at[slot] == kNone) continue;
    std::complex<double> target = 0;
    std::size_t entry = level.layout().first_entry(slot);
    for (Index k = 0; k < level.layout().width(slot); ++k, entry += kLanes) {
      const std::complex<double> z_j = level.z[level.layout().neighbor[entry]];
      if (level.layout().neighbor[entry] == slot) continue;
      target += std::complex<double>(level.couplings.direct_at(entry)) * z_j +
                std::complex<double>(
                    level.couplings.reflecting_at(level.layout(), slot / kLanes, entry)) *
                    std::conj(z_j);
    }
    if (!level.couplings.anchor.empty()) {
      target += 2.0 * std::complex<double>(level.couplings.anchor[slot]);
    }
    sum += (std::conj(std::complex<double>(level.z[slot])) * target).real();
  }
  return sum;
}

void randomize(Level& level, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> angle(0, 6.2831853f);
  for (Complex& z : level.z) z = std::polar(1.0f, angle(random));
}

TEST(Hierarchy, CoarseEnergyIsThatOfTheProlongedPhasesUpToAConstant) {
  Hierarchy hierarchy = build_hierarchy(reflecting_graph(true));
  ASSERT_GT(hierarchy.levels.size(), 4u);
  // Only the first coarsening: later ones drop what reflects an aggregate onto itself.
  Level& fine = hierarchy.levels[0];
  Level& coarse = hierarchy.levels[1];
  std::vector<double> differences;
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    randomize(coarse, seed);
    prolong(coarse, fine);
    differences.push_back(agreement(fine) - agreement(coarse));
  }
  const double scale = std::abs(agreement(fine));
  for (const double d : differences) EXPECT_NEAR(d, differences[0], 1e-5 * scale);
}

TEST(Hierarchy, SweepsNeverRaiseTheEnergyHoweverFarTheyReach) {
  for (Level& level : build_hierarchy(reflecting_graph(true)).levels) {
    for (const float over_relaxation : {1.0f, 1.5f, 1.9f}) {
      randomize(level, 7);
      double last = agreement(level);
      for (int sweeps = 0; sweeps < 6; ++sweeps) {
        sweep(level.layout(), level.couplings, level.z, over_relaxation);
        const double now = agreement(level);
        EXPECT_GE(now, last - 1e-5 * std::abs(last));
        last = now;
      }
    }
  }
}

TEST(Hierarchy, EveryLevelHasAtMostAboutHalfTheNodesOfTheOneBefore) {
  const Hierarchy hierarchy = build_hierarchy(reflecting_graph(true));
  for (std::size_t l = 1; l < hierarchy.levels.size(); ++l) {
    EXPECT_LE(2 * hierarchy.levels[l].layout().slot_of.size(),
              hierarchy.levels[l - 1].layout().slot_of.size());
  }
  EXPECT_EQ(hierarchy.levels.back().layout().entry_count(), 0u);
}

TEST(Hierarchy, OfUnconnectedPiecesEndsWithOneNodeEach) {
  const auto surface = wavy_surface("pieces,count=5,resolution=6", Vec3(0.1f, 1, 0.2f), 10);
  const Hierarchy hierarchy = build_hierarchy(surface.graph());
  std::size_t ends = hierarchy.levels.back().layout().slot_of.size();
  for (std::size_t l = 0; l + 1 < hierarchy.levels.size(); ++l) {
    const Index outside = hierarchy.levels[l + 1].layout().slot_count();
    for (const Index slot : hierarchy.levels[l].layout().slot_of) {
      ends += hierarchy.levels[l].aggregation().coarse_slot[slot] == outside;
    }
  }
  EXPECT_EQ(ends, 5u) << "nodes that belong to no coarser one";
}

TEST(Hierarchy, RenewedSumsAreThoseOfTheFirstBuild) {
  Hierarchy hierarchy = build_hierarchy(reflecting_graph(true));
  const double before = [&] {
    randomize(hierarchy.levels[2], 1);
    return agreement(hierarchy.levels[2]);
  }();
  renew(hierarchy);
  EXPECT_EQ(agreement(hierarchy.levels[2]), before);
}

TEST(Hierarchy, RenewedSumsAreThoseOfTheFirstBuildAfterCyclesToo) {
  Hierarchy hierarchy = build_hierarchy(reflecting_graph(true));
  descend(hierarchy, 2);
  const std::vector<Complex> first = hierarchy.levels[0].z;
  run_cycles(hierarchy, 2, 3, {});
  renew(hierarchy);
  descend(hierarchy, 2);
  EXPECT_EQ(hierarchy.levels[0].z, first);
}

#ifdef BRINDLE_HAS_TBB
TEST(Hierarchy, HasRoomForThreadsThatWereNotThereWhenItWasBuilt) {
  Hierarchy hierarchy;
  tbb::task_arena(1).execute([&] { hierarchy = build_hierarchy(reflecting_graph(true)); });
  const std::size_t many = thread_capacity() + 5;
  tbb::task_arena(static_cast<int>(many)).execute([&] { renew(hierarchy); });
  ASSERT_GE(hierarchy.scratch.threads.size(), many);
  for (const SumScratch::OfThread& own : hierarchy.scratch.threads) {
    EXPECT_EQ(own.gauged.size(), hierarchy.scratch.threads[0].gauged.size());
    EXPECT_EQ(own.marked.size(), hierarchy.scratch.threads[0].marked.size());
    EXPECT_GE(own.reflecting.capacity(), hierarchy.scratch.entries);
  }
}
#endif  // BRINDLE_HAS_TBB

TEST(Hierarchy, OfAStarAndOfNothingIsBuilt) {
  // A hub with a hundred leaves must not need a hundred levels.
  auto adjacency = std::make_shared<Adjacency>();
  adjacency->offsets.push_back(100);
  for (Index leaf = 1; leaf <= 100; ++leaf) adjacency->neighbors.push_back(leaf);
  for (Index leaf = 1; leaf <= 100; ++leaf) {
    adjacency->neighbors.push_back(0);
    adjacency->offsets.push_back(100 + leaf);
  }
  PhaseGraph star;
  star.coupling.assign(200, Complex(1));
  star.reflecting.assign(200, 0);
  star.adjacency = adjacency;
  EXPECT_LE(build_hierarchy(star).levels.size(), 3u);

  PhaseGraph nothing;
  nothing.adjacency = std::make_shared<Adjacency>();
  EXPECT_EQ(build_hierarchy(nothing).levels.size(), 1u);
}

}  // namespace
}  // namespace brindle
