/// The global optimum of the relaxed energy: the quality reference (Knöppel et al. 2015).
#pragma once

#include <span>

#include "brindle/solver.h"

namespace brindle {

/// Minimises the energy over complex numbers of any length under sum_i mass_i |z_i|^2 = 1: the
/// smallest eigenvector (`mass` has one entry per node, or none for 1), by
/// `options.global_iterations` inverse iterations on a sparse Cholesky factor (CHOLMOD), then makes
/// every z_i a unit number. Anchors do not enter. BLAS works on one thread meanwhile: the result is
/// the same for every number of threads. Throws Error if brindle was built without CHOLMOD or the
/// factorisation fails.
PhaseSolution solve_global(const PhaseGraph& graph, std::span<const float> mass,
                           const SolverOptions& options, const Progress& progress = {});

}  // namespace brindle
