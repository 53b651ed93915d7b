#include "brindle/phases/averaged.h"

#include <utility>

#include "brindle/error.h"
#include "brindle/phases/relaxation.h"

namespace brindle {
namespace {

std::vector<Complex> passed_down(const AveragedLevel& level, const std::vector<Complex>& coarse) {
  std::vector<Complex> z(level.parent.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    const Complex z_parent = coarse[level.parent[i]];
    z[i] = level.transfer[i] * (level.transfer_reflects[i] ? std::conj(z_parent) : z_parent);
  }
  return z;
}

}  // namespace

PhaseSolution solve_averaged(const PhaseGraph& graph, std::span<const AveragedLevel> levels,
                             const SolverOptions& options, const Progress& progress) {
  if (levels.empty()) {
    throw Error(
        "the averaged solver needs averaged levels of its phase graph; averaged_levels "
        "(waves/averaged_levels.h) makes them");
  }
  PhaseSolution solution = relax(levels.back().graph, options, {}, progress);
  for (std::size_t l = levels.size(); l-- > 0;) {
    const PhaseGraph& finer = l > 0 ? levels[l - 1].graph : graph;
    const PhaseSolution coarse = std::move(solution);
    solution = relax(finer, options, passed_down(levels[l], coarse.z), progress);
    solution.topology_milliseconds += coarse.topology_milliseconds;
    solution.solve_milliseconds += coarse.solve_milliseconds;
  }
  return solution;
}

}  // namespace brindle
