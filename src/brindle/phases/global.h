/// The global optimum of the relaxed energy (Knöppel et al. 2015): the quality reference.
#pragma once

#include <span>

#include "brindle/solver.h"

namespace brindle {

/// Minimises the energy over complex numbers of any length under sum_i mass_i |z_i|^2 = 1: the
/// smallest eigenvector, by `options.global_iterations` inverse iterations on a sparse Cholesky
/// factor (CHOLMOD). Then every z_i is scaled to length 1. `mass` has one entry per node; empty: 1.
/// Anchors are ignored. BLAS runs on one thread so that results do not depend on the number of
/// threads. Throws Error without CHOLMOD, for another number of masses, and if the factorisation
/// fails; Cancelled if `progress` cancels.
PhaseSolution solve_global(const PhaseGraph& graph, std::span<const float> mass,
                           const SolverOptions& options, const Progress& progress = {});

}  // namespace brindle
