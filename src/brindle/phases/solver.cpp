#include "brindle/phases/solver.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/phases/averaged.h"
#include "brindle/phases/global.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/relaxation.h"

namespace brindle {
namespace {

constexpr std::array<std::pair<std::string_view, Solver>, 4> kNames{
    {{"multilevel", Solver::multilevel},
     {"relaxation", Solver::relaxation},
     {"averaged", Solver::averaged},
     {"global", Solver::global}}};

void require(bool holds, const char* message) {
  if (!holds) throw Error(std::string("solver options: ") + message);
}

PhaseSolution solve_multilevel(const PhaseGraph& graph, const SolverOptions& options,
                               const Progress& progress) {
  PhaseSolution solution;
  Hierarchy hierarchy = build_hierarchy(graph, progress);
  solution.topology_milliseconds = hierarchy.topology_milliseconds;
  Stopwatch watch;
  descend(hierarchy, options.sweeps);
  run_cycles(hierarchy, options.sweeps, options.cycles, progress);
  solution.z = to_nodes(hierarchy.levels[0].layout(), hierarchy.levels[0].z);
  solution.solve_milliseconds = hierarchy.numeric_milliseconds + watch.lap();
  solution.iterations = options.sweeps * (1 + options.cycles);
  solution.energy = energy(graph, solution.z);
  return solution;
}

/// Cycles from the phases of another solver.
void improve(const PhaseGraph& graph, const SolverOptions& options, const Progress& progress,
             PhaseSolution& solution) {
  Stopwatch watch;
  Hierarchy hierarchy = build_hierarchy(graph, progress);
  Level& finest = hierarchy.levels[0];
  for (std::size_t node = 0; node < solution.z.size(); ++node) {
    finest.z[finest.layout().slot_of[node]] = solution.z[node];
  }
  run_cycles(hierarchy, options.sweeps, options.cycles, progress);
  solution.z = to_nodes(finest.layout(), finest.z);
  solution.topology_milliseconds += hierarchy.topology_milliseconds;
  solution.solve_milliseconds += watch.lap() - hierarchy.topology_milliseconds;
  solution.iterations += options.sweeps * options.cycles;
  solution.energy = energy(graph, solution.z);
}

PhaseSolution solve_without_cycles(const PhaseGraph& graph, const SolverOptions& options,
                                   const Progress& progress) {
  if (options.solver == Solver::relaxation) return relax(graph, options, {}, progress);
  if (options.solver == Solver::averaged) return solve_averaged(graph, options, progress);
  return solve_global(graph, options, progress);
}

}  // namespace

std::optional<Solver> solver_of(std::string_view name) {
  for (const auto& [known, solver] : kNames) {
    if (known == name) return solver;
  }
  return std::nullopt;
}

std::string_view name_of(Solver solver) { return kNames[static_cast<std::size_t>(solver)].first; }

bool is_available(Solver solver) {
#ifdef BRINDLE_HAS_CHOLMOD
  constexpr bool has_cholmod = true;
#else
  constexpr bool has_cholmod = false;
#endif
  return has_cholmod || solver != Solver::global;
}

void check(const SolverOptions& options) {
  require(std::isfinite(options.epsilon) && options.epsilon >= 0, "epsilon must be 0 or above");
  require(options.momentum >= 0 && options.momentum < 1, "momentum must be in [0, 1)");
  require(options.max_iterations > 0, "max_iterations must be above 0");
  require(options.sweeps >= 0, "sweeps must be 0 or above");
  require(options.cycles >= 0, "cycles must be 0 or above");
  require(options.global_iterations > 0, "global_iterations must be above 0");
}

PhaseSolution solve_phases(const PhaseGraph& graph, const SolverOptions& options,
                           const Progress& progress) {
  check(options);
  if (options.solver == Solver::multilevel) return solve_multilevel(graph, options, progress);
  PhaseSolution solution = solve_without_cycles(graph, options, progress);
  if (options.cycles > 0) improve(graph, options, progress, solution);
  return solution;
}

}  // namespace brindle
