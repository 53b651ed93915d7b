#include "brindle/phases/averaged.h"

#include <cmath>
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
  // Coarse levels are small: each takes a part of what is left, half of all for the last.
  const auto part = [&](std::size_t finer) {
    const auto end = [](std::size_t levels_left) {
      return std::pow(0.5, static_cast<double>(levels_left));
    };
    return progress.part(finer == levels.size() ? 0 : end(finer + 1), end(finer));
  };
  PhaseSolution solution = relax(levels.back().graph, options, {}, part(levels.size()));
  for (std::size_t l = levels.size(); l-- > 0;) {
    const PhaseGraph& finer = l > 0 ? levels[l - 1].graph : graph;
    const PhaseSolution coarse = std::move(solution);
    solution = relax(finer, options, passed_down(levels[l], coarse.z), part(l));
    solution.topology_milliseconds += coarse.topology_milliseconds;
    solution.solve_milliseconds += coarse.solve_milliseconds;
  }
  return solution;
}

}  // namespace brindle
