/// The command line's side of the table of options.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/option_table.h"

namespace brindle::tool {

/// The job that a command does; of those that do none, whose options are `stripe`'s, that.
PatternJob job_of(const std::string& command);

/// Says what the table has of the options of `app`: help, form, range, and which of them need and
/// exclude each other. Options that have been described already keep their words.
void describe_options(CLI::App& app, PatternJob job);

/// The words of `needs`, `excludes` and `files`.
std::vector<std::string> words_between_spaces(std::string_view words);

}  // namespace brindle::tool
