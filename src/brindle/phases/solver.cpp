#include "brindle/solver.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/phases/global.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/parsed_words.h"
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

/// The multilevel solver, or its cycles from the phases of another solver.
void add_multilevel(const PhaseGraph& graph, const SolverOptions& options, const Progress& progress,
                    PhaseSolution& solution) {
  Stopwatch watch;
  double load_milliseconds = 0;
  const auto load = [&](Level& finest) {
    watch.lap();
    load_couplings(graph, finest.layout(), finest.couplings);
    load_milliseconds = watch.lap();
  };
  PhaseSolution last = std::move(solution);
  solution = solve_multilevel(*graph.adjacency, load, options, last.z, progress);
  solution.energy = energy(graph, solution.z);
  solution.iterations += last.iterations;
  solution.energy_per_iteration = std::move(last.energy_per_iteration);
  solution.topology_milliseconds += last.topology_milliseconds;
  solution.solve_milliseconds += last.solve_milliseconds + load_milliseconds;
}

std::vector<JobStage> stages_of(const SolverOptions& options) {
  if (options.solver == Solver::multilevel) return {{"multilevel", 1}};
  std::vector<JobStage> stages = {{std::string(name_of(options.solver)), 3}};
  if (options.cycles > 0) stages.push_back({"multilevel", 1});
  return stages;
}

}  // namespace

std::optional<Solver> parse_solver(std::string_view name) {
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

void check_solver_options(const SolverOptions& options) {
  require(std::isfinite(options.epsilon) && options.epsilon >= 0, "epsilon must be 0 or above");
  require(options.momentum >= 0 && options.momentum < 1, "momentum must be in [0, 1)");
  require(options.max_iterations > 0, "max_iterations must be above 0");
  require(options.sweeps >= 0, "sweeps must be 0 or above");
  require(options.cycles >= 0, "cycles must be 0 or above");
  require(options.global_iterations > 0, "global_iterations must be above 0");
}

PhaseSolution solve_phases(const PhaseGraph& graph, const SolverOptions& options,
                           const Progress& progress, const SolverData& data) {
  check_solver_options(options);
  PhaseSolution solution;
  JobStages stages(progress, stages_of(options));
  const auto begin = [&] { return stages.begin(name_of(options.solver)); };
  switch (options.solver) {
    case Solver::relaxation:
      solution = relax(graph, options, {}, begin());
      break;
    case Solver::averaged:
      solution = solve_averaged(graph, data.averaged, options, begin());
      break;
    case Solver::global:
      solution = solve_global(graph, data.mass, options, begin());
      break;
    case Solver::multilevel:
      break;
  }
  if (options.solver == Solver::multilevel || options.cycles > 0) {
    add_multilevel(graph, options, stages.begin("multilevel"), solution);
  }
  stages.finish();
  return solution;
}

}  // namespace brindle
