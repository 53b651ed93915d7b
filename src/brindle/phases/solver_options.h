/// Valid ranges of solver options.
#pragma once

#include "brindle/solver.h"

namespace brindle {

/// Throws Error for options out of range.
void check_solver_options(const SolverOptions& options);

}  // namespace brindle
