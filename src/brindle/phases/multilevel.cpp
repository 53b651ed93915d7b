#include "brindle/phases/multilevel.h"

#include <algorithm>
#include <cmath>

#include "brindle/base/parallel.h"
#include "brindle/base/ranges.h"
#include "brindle/phases/sliced_kernels.h"

namespace brindle {

LevelSweeps sweeps_on_level(Index slot_count, int sweeps) {
  constexpr float kOverRelaxation = 1.5f;
  if (slot_count < kSmallLevel) return {4 * sweeps, kOverRelaxation};
  if (slot_count < 4 * kSmallLevel) return {2 * sweeps, kOverRelaxation};
  return {sweeps, 1};
}

void sweep_level(Level& level, int sweeps) {
  const LevelSweeps planned = sweeps_on_level(level.layout().slot_count(), sweeps);
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

void descend_from(Hierarchy& hierarchy, Complex start, int sweeps, const Progress& progress) {
  auto& levels = hierarchy.levels;
  ranges::fill(levels.back().z, start);
  for (std::size_t l = levels.size(); l-- > 0;) {
    // Each level takes about a quarter of the time of the next finer one.
    progress.report(std::pow(0.25, static_cast<double>(l + 1)));
    if (l + 1 < levels.size()) prolong(levels[l + 1], levels[l]);
    sweep_level(levels[l], sweeps);
  }
}

void correct(Hierarchy& hierarchy, int sweeps, bool has_finest, const Progress& progress) {
  hierarchy.corrected = true;
  for (std::size_t l = 0; l + 1 < hierarchy.levels.size(); ++l) {
    if (l < 2) progress.report(0.3 * static_cast<double>(l));
    set_turns(hierarchy.levels[l], has_finest && l == 0);
    renew_sums(hierarchy.levels[l], hierarchy.levels[l + 1], hierarchy.scratch);
  }
  descend_from(hierarchy, Complex(1), sweeps, progress.part(0.5, 1));
}

void descend(Hierarchy& hierarchy, int sweeps, const Progress& progress) {
  descend_from(hierarchy, kPeak, sweeps, progress);
}

void run_cycles(Hierarchy& hierarchy, int sweeps, int cycles, const Progress& progress) {
  const Progress cycling = progress.step("cycles");
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const double each = 1.0 / cycles;
    correct(hierarchy, sweeps, true, cycling.part(cycle * each, (cycle + 1) * each));
  }
}

std::vector<JobStage> multilevel_stages() {
  return {{"couple", 3}, {"hierarchy", 5}, {"descent", 1}, {"cycles", 3}};
}

}  // namespace brindle
