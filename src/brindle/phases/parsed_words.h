/// Words of solvers, as command lines and scripts have them.
#pragma once

#include <optional>
#include <string_view>

#include "brindle/solver.h"

namespace brindle {

/// Reads what `name_of` gives. Empty if there is no such solver.
std::optional<Solver> parse_solver(std::string_view name);

}  // namespace brindle
