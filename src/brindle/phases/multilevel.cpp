#include "brindle/phases/multilevel.h"

#include <algorithm>

#include "brindle/base/parallel.h"
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

void descend_from(Hierarchy& hierarchy, Complex start, int sweeps) {
  auto& levels = hierarchy.levels;
  std::ranges::fill(levels.back().z, start);
  for (std::size_t l = levels.size(); l-- > 0;) {
    if (l + 1 < levels.size()) prolong(levels[l + 1], levels[l]);
    sweep_level(levels[l], sweeps);
  }
}

void correct(Hierarchy& hierarchy, int sweeps, bool has_finest) {
  hierarchy.corrected = true;
  for (std::size_t l = 0; l + 1 < hierarchy.levels.size(); ++l) {
    set_turns(hierarchy.levels[l], has_finest && l == 0);
    renew_sums(hierarchy.levels[l], hierarchy.levels[l + 1], hierarchy.scratch);
  }
  descend_from(hierarchy, Complex(1), sweeps);
}

void descend(Hierarchy& hierarchy, int sweeps) { descend_from(hierarchy, kPeak, sweeps); }

void run_cycles(Hierarchy& hierarchy, int sweeps, int cycles, const Progress& progress) {
  for (int cycle = 0; cycle < cycles; ++cycle) {
    progress.report("cycles", static_cast<double>(cycle) / cycles);
    correct(hierarchy, sweeps);
  }
}

}  // namespace brindle
