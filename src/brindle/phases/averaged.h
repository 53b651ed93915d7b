/// The paper's hierarchical optimisation on averaged inputs (3.4).
#pragma once

#include "brindle/solver.h"

namespace brindle {

/// Relaxes the coarsest of the graph's averaged levels from a random start, then passes the phases
/// down level by level, relaxing each until it has converged.
/// Throws Error if the graph has no averaged levels.
PhaseSolution solve_averaged(const PhaseGraph& graph, const SolverOptions& options,
                             const Progress& progress = {});

}  // namespace brindle
