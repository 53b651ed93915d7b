/// The reference of all options, docs/options.md.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace brindle::tool {

/// Markdown: the rows of the option table by group, then the options that only one command has.
std::string option_reference(const CLI::App& tool);

}  // namespace brindle::tool
