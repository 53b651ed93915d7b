/// The fast solvers against the plain ones of reference_solver.h.
#include "reference_solver.h"

#include <gtest/gtest.h>

#include "brindle/base/random.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/relaxation.h"
#include "brindle/phases/sliced_kernels.h"
#include "reflecting_graph.h"

namespace brindle {
namespace {

using namespace testing_support;

/// The solvers' hashed random start.
Phases random_start(const PhaseGraph& graph) {
  Phases z;
  for (Index i = 0; i < graph.node_count(); ++i) z.emplace_back(random_phase(i));
  return z;
}

double largest_difference(std::span<const Complex> fast, const Phases& plain) {
  double largest = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    largest = std::max(largest, std::abs(Number(fast[i]) - plain[i]));
  }
  return largest;
}

TEST(ReferenceSolver, HasTheEnergyOfBothForms) {
  const PhaseGraph graph = reflecting_graph(false);
  const Phases z = random_start(graph);
  const std::vector<Complex> rounded(z.begin(), z.end());
  EXPECT_NEAR(energy(graph, rounded), energy_of(graph, z), 1e-9);
  Hierarchy hierarchy = build_hierarchy(graph);
  Level& finest = hierarchy.levels[0];
  to_slots(finest.layout(), rounded, finest.z);
  EXPECT_NEAR(energy(finest.layout(), finest.couplings, finest.z), energy_of(graph, z), 1e-9);
}

TEST(ReferenceSolver, SweepsAsSlicesDo) {
  const PhaseGraph graph = reflecting_graph(true);
  const Coloring coloring = greedy_coloring(*graph.adjacency);
  for (const float over_relaxation : {1.0f, 1.5f}) {
    Hierarchy hierarchy = build_hierarchy(graph);
    Level& finest = hierarchy.levels[0];
    Phases z = random_start(graph);
    to_slots(finest.layout(), std::vector<Complex>(z.begin(), z.end()), finest.z);
    for (int n = 0; n < 3; ++n) {
      sweep(finest.layout(), finest.couplings, finest.z, over_relaxation);
      sweep_plainly(graph, coloring, z, over_relaxation);
    }
    EXPECT_LT(largest_difference(to_nodes(finest.layout(), finest.z), z), 1e-3);
  }
}

TEST(ReferenceSolver, RelaxesAsThePaperDoes) {
  const PhaseGraph graph = reflecting_graph(false);
  SolverOptions options;
  options.max_iterations = 12;
  options.epsilon = 0;
  Phases z = random_start(graph);
  const std::vector<double> energies =
      relax_plainly(graph, luby_coloring(*graph.adjacency), options, z);
  const PhaseSolution fast = relax(graph, options);
  ASSERT_EQ(fast.energy_per_iteration.size(), energies.size());
  EXPECT_EQ(fast.iterations + 1u, energies.size());
  EXPECT_NEAR(energies.front(), 0.5, 0.05);
  for (std::size_t k = 0; k < energies.size(); ++k) {
    EXPECT_NEAR(fast.energy_per_iteration[k], energies[k], 1e-5) << k;
  }
  EXPECT_LT(largest_difference(fast.z, z), 1e-2);
}

TEST(ReferenceSolver, SumsAsTheFirstCoarsening) {
  const PhaseGraph graph = reflecting_graph(false);
  const Hierarchy hierarchy = build_hierarchy(graph);
  const Level &fine = hierarchy.levels[0], &coarse = hierarchy.levels[1];
  std::vector<Index> parent;
  Phases gauge;
  std::vector<bool> conjugated;
  for (const Index slot : fine.layout().slot_of) {
    parent.push_back(fine.aggregation().coarse_slot[slot]);
    gauge.emplace_back(fine.gauge[slot]);
    conjugated.push_back(conjugate_bit(fine.gauge[slot]));
  }
  const auto sums = sums_plainly(graph, parent, gauge, conjugated);
  std::size_t entries = 0;
  for (const Index slot : coarse.layout().slot_of) {
    for (Index k = 0; k < coarse.layout().width(slot); ++k) {
      const std::size_t entry = coarse.layout().first_entry(slot) + std::size_t{k} * kLanes;
      const Index neighbor = coarse.layout().neighbor[entry];
      if (neighbor == slot) continue;  // padding
      const auto& [a, b] = sums.at({slot, neighbor});
      ASSERT_LT(std::abs(Number(coarse.couplings.direct_at(entry)) - a), 1e-5);
      ASSERT_LT(
          std::abs(Number(coarse.couplings.reflecting_at(coarse.layout(), slot / kLanes, entry)) -
                   b),
          1e-5);
      ++entries;
    }
  }
  EXPECT_EQ(entries, sums.size());
}

TEST(ReferenceSolver, CanHardlyImproveWhatTheMultilevelSolverFinds) {
  for (const char* shape : {"torus,resolution=40", "sphere,resolution=16"}) {
    const PhaseGraph graph = wavy_surface(shape, kAxis, 12).graph();
    const Coloring coloring = greedy_coloring(*graph.adjacency);
    SolverOptions options;
    options.epsilon = 1e-3f;
    Phases relaxed = random_start(graph);
    relax_plainly(graph, coloring, options, relaxed);
    const PhaseSolution fast = solve_phases(graph);
    EXPECT_LE(fast.energy, energy_of(graph, relaxed)) << shape;
    Phases z(fast.z.begin(), fast.z.end());
    for (int n = 0; n < 100; ++n) sweep_plainly(graph, coloring, z);
    EXPECT_GT(energy_of(graph, z), 0.8 * fast.energy) << shape;
  }
}

}  // namespace
}  // namespace brindle
