/// The paper's local optimisation (3.2, 3.3 and section 4).
#pragma once

#include <span>

#include "brindle/phases/solver.h"

namespace brindle {

/// Iterates Eq. 8 to 11 colour by colour from `start` (one unit number per node; empty for the
/// hashed random start) until the relative energy improvement (Eq. 12) drops below
/// `options.epsilon`.
PhaseSolution relax(const PhaseGraph& graph, const SolverOptions& options,
                    std::span<const Complex> start = {}, const Progress& progress = {});

}  // namespace brindle
