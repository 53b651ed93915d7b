#include "brindle/phases/multilevel.h"

#include <algorithm>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/base/stopwatch.h"
#include "brindle/phases/sliced_kernels.h"

namespace brindle {

SweepPlan SweepPlan::for_new_levels(int sweeps, Index finest) {
  SweepPlan plan(sweeps);
  if (finest >= kLargeLevel) plan.large_ = finest;
  return plan;
}

LevelSweeps SweepPlan::on_level(Index slot_count) const {
  constexpr float kOfSmall = 1.5f, kOfLarge = 1.7f;
  if (slot_count < kSmallLevel) return {4 * sweeps_, kOfSmall};
  if (slot_count < 4 * kSmallLevel) return {2 * sweeps_, kOfSmall};
  if (large_ == 0) return {sweeps_, 1};
  // The finest level, the next one, and all others: each level has about a quarter of the slots.
  if (slot_count > large_ / 2) return {3 * sweeps_, kOfLarge};
  return {(slot_count > large_ / 8 ? 6 : 12) * sweeps_, kOfLarge};
}

void sweep_level(Level& level, SweepPlan plan) {
  const LevelSweeps planned = plan.on_level(level.layout().slot_count());
  for (int number = 0; number < planned.count; ++number) {
    sweep(level.layout(), level.couplings, level.z, planned.over_relaxation_of(number));
  }
}

void set_turns(Level& level, bool is_finest) {
  parallel_for(level.gauge.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Complex now = is_finest ? level.z[slot] : Complex(1);
      level.gauge[slot] = with_conjugate_bit(now, conjugate_bit(level.gauge[slot]));
    }
  });
}

void descend_from(Hierarchy& hierarchy, Complex start, SweepPlan plan, const Progress& progress) {
  auto& levels = hierarchy.levels;
  ranges::fill(levels.back().z, start);
  for (std::size_t l = levels.size(); l-- > 0;) {
    progress.tick();
    if (l + 1 < levels.size()) prolong(levels[l + 1], levels[l]);
    sweep_level(levels[l], plan);
  }
}

void descend(Hierarchy& hierarchy, SweepPlan plan, const Progress& progress) {
  descend_from(hierarchy, kPeak, plan, progress);
}

void correct(Hierarchy& hierarchy, SweepPlan plan, bool has_finest, const Progress& progress) {
  hierarchy.corrected = true;
  for (std::size_t l = 0; l + 1 < hierarchy.levels.size(); ++l) {
    progress.tick();
    set_turns(hierarchy.levels[l], has_finest && l == 0);
    renew_sums(hierarchy.levels[l], hierarchy.levels[l + 1], hierarchy.scratch);
  }
  descend_from(hierarchy, Complex(1), plan, progress);
}

void run_cycles(Hierarchy& hierarchy, SweepPlan plan, int cycles, const Progress& progress) {
  const Progress cycling = progress.step("cycles");
  for (int cycle = 0; cycle < cycles; ++cycle) {
    cycling.report(static_cast<double>(cycle) / cycles);
    correct(hierarchy, plan, true, cycling);
  }
}

PhaseSolution solve_multilevel(const Adjacency& adjacency,
                               const std::function<void(Level& finest)>& couple,
                               const SolverOptions& options, std::span<const Complex> start,
                               const Progress& progress,
                               const std::function<void(std::span<Complex> z)>& finish) {
  check_solver_options(options);
  JobStages stages(progress, {{"couple", 3}, {"hierarchy", 5}, {"descent", 1}, {"cycles", 3}});
  Hierarchy hierarchy = finest_level(adjacency, stages.begin("couple"));
  couple(hierarchy.levels[0]);
  coarsen(hierarchy, stages.begin("hierarchy"));
  Stopwatch watch;
  Level& finest = hierarchy.levels[0];
  const Index slots = finest.layout().slot_count();
  const SweepPlan plan = SweepPlan::for_new_levels(options.sweeps, slots);
  const Progress descent = stages.begin("descent");
  if (start.empty()) {
    descend(hierarchy, plan, descent);
  } else {
    to_slots(finest.layout(), start, finest.z);
  }
  run_cycles(hierarchy, plan, options.cycles, stages.begin("cycles"));
  PhaseSolution solution;
  solution.z = to_nodes(finest.layout(), finest.z);
  if (finish) {
    finish(solution.z);
    to_slots(finest.layout(), solution.z, finest.z);
  }
  solution.solve_milliseconds = hierarchy.numeric_milliseconds + watch.lap();
  solution.topology_milliseconds = hierarchy.topology_milliseconds;
  solution.iterations = plan.on_level(slots).count * (options.cycles + (start.empty() ? 1 : 0));
  solution.energy = energy(finest.layout(), finest.couplings, finest.z);
  stages.finish();
  return solution;
}

}  // namespace brindle
