/// All solvers: from a phase graph to phases.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"

namespace BRINDLE_EXPORT brindle {

/// The methods of `solve_phases`.
enum class Solver {
  multilevel,  ///< hierarchy of exact sums (docs/method.md); the default
  relaxation,  ///< the paper's local optimisation (3.2, 3.3, section 4)
  averaged,    ///< the paper's hierarchy of averaged inputs (3.4)
  global       ///< smallest eigenvector (Knöppel et al. 2015); needs a build with CHOLMOD
};

std::string_view name_of(Solver solver);

/// Whether this build has the solver: every build has all but `global`.
bool is_available(Solver solver);

/// Options of all solvers.
struct SolverOptions {
  Solver solver = Solver::multilevel;

  // relaxation and averaged
  float epsilon = 0.02f;        ///< stop when the relative energy improvement (Eq. 12) is below
  float momentum = 0.2f;        ///< s_m of Eq. 11; 0 for none
  bool skip_last_third = true;  ///< of the colours, on every second iteration
  int max_iterations = 10000;
  std::uint32_t seed = 0;  ///< added to the node number before hashing

  // multilevel, and cycles after any solver
  int sweeps = 2;  ///< coloured sweeps per level; more on small levels and large graphs
                   ///< (docs/method.md)
  int cycles = 0;  ///< further descents of the multilevel solver, each from the phases before

  // global
  int global_iterations = 20;  ///< inverse iterations
};

/// Phases and the solver's work.
struct PhaseSolution {
  std::vector<Complex> z;  ///< one unit number per node
  double energy = 0;       ///< of `z`, as `energy()` of phase_graph.h defines it
  int iterations = 0;      ///< sweeps over the finest level, or inverse iterations
  std::vector<double> energy_per_iteration;  ///< before the first iteration and after each, without
                                             ///< cycles; empty for multilevel and global
  /// For what depends only on connectivity: colours, aggregates, order.
  double topology_milliseconds = 0;
  double solve_milliseconds = 0;
};

/// Additional input of some solvers.
struct SolverData {
  std::vector<float> mass;              ///< of Solver::global: one per node, above 0; empty: 1
  std::vector<AveragedLevel> averaged;  ///< of Solver::averaged: coarser levels, finest first
};

/// Solves for phases. Throws Error for options out of range, no averaged levels for
/// Solver::averaged, or a build without CHOLMOD for Solver::global; Cancelled if `progress`
/// cancels.
PhaseSolution solve_phases(const PhaseGraph& graph, const SolverOptions& options = {},
                           const Progress& progress = {}, const SolverData& data = {});

}  // namespace brindle
