/// Options for the maker's hand on where stripes begin, wind and branch.
#pragma once

#include <CLI/CLI.hpp>

#include "brindle/pattern_of.h"

namespace brindle::tool {

void add_making_options(CLI::App& app, MakingOptions& options);

/// A whole number, or a loop's name and one: "boundary-1:2". Throws CLI::ValidationError for
/// another text.
WantedWinding parse_winding(const std::string& option, const std::string& text);

/// Throws CLI::ValidationError for options that contradict each other or the solver.
void check_making_options(const MakingOptions& options, Solver solver);

}  // namespace brindle::tool
