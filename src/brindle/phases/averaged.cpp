#include "brindle/phases/averaged.h"

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

PhaseSolution solve_level(const PhaseGraph& graph, const SolverOptions& options,
                          const Progress& progress) {
  if (!graph.averaged) return relax(graph, options, {}, progress);
  const PhaseSolution coarse = solve_level(graph.averaged->graph, options, progress);
  PhaseSolution solution = relax(graph, options, passed_down(*graph.averaged, coarse.z), progress);
  solution.topology_milliseconds += coarse.topology_milliseconds;
  solution.solve_milliseconds += coarse.solve_milliseconds;
  return solution;
}

}  // namespace

PhaseSolution solve_averaged(const PhaseGraph& graph, const SolverOptions& options,
                             const Progress& progress) {
  if (!graph.averaged) {
    throw Error(
        "the averaged solver needs a phase graph with averaged levels; "
        "build it with attach_averaged_levels (waves/averaged_levels.h)");
  }
  return solve_level(graph, options, progress);
}

}  // namespace brindle
