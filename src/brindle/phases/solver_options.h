/// Whether solvers are known by a name, and their options in range.
#pragma once

#include <optional>
#include <string_view>

#include "brindle/solver.h"

namespace brindle {

/// Reads what `name_of` gives. Empty if there is no such solver.
std::optional<Solver> parse_solver(std::string_view name);

/// Throws Error for options out of range.
void check_solver_options(const SolverOptions& options);

}  // namespace brindle
