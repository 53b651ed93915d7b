/// The paper's hierarchical optimisation on averaged inputs (3.4).
#pragma once

#include <span>

#include "brindle/solver.h"

namespace brindle {

/// Relaxes the coarsest of the graph's averaged levels from a random start, then passes the phases
/// down level by level, relaxing each until it has converged. Throws Error if there are no levels.
PhaseSolution solve_averaged(const PhaseGraph& graph, std::span<const AveragedLevel> levels,
                             const SolverOptions& options, const Progress& progress = {});

}  // namespace brindle
