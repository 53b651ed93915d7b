/// Names of solvers on command lines and in scripts.
#pragma once

#include <optional>
#include <string_view>

#include "brindle/solver.h"

namespace brindle {

/// The solver of this name (`name_of`); empty if there is none.
std::optional<Solver> parse_solver(std::string_view name);

}  // namespace brindle
