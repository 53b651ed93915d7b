/// Connects command lines to the option table.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/option_table.h"

namespace brindle::tool {

/// The job of a command; `stripe` for commands without one, as they have its options.
PatternJob job_of(const std::string& command);

/// The row of an option, by any of its names; null if the table has none.
const OptionInfo* row_of(const CLI::Option& option, PatternJob job);

/// Sets help, group, form, range, needs and excludes of the options of `app` from the table.
/// Options with a description keep it.
void describe_options(CLI::App& app, PatternJob job);

/// The words of `needs`, `excludes` and `files`.
std::vector<std::string> words_between_spaces(std::string_view words);

}  // namespace brindle::tool
