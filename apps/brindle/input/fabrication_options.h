/// Options of fabrication: where stripes begin, wind and branch.
#pragma once

#include <CLI/CLI.hpp>

#include "brindle/pattern_of.h"

namespace brindle::tool {

void add_fabrication_options(CLI::App& app, FabricationOptions& options);

/// An integer, or a loop's name and an integer: "boundary-1:2". Throws CLI::ValidationError for
/// other text.
WantedWinding parse_winding(const std::string& option, const std::string& text);

/// Throws CLI::ValidationError for options that contradict each other or the solver.
void check_fabrication_options(const FabricationOptions& options, Solver solver);

}  // namespace brindle::tool
