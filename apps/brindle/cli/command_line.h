/// What was asked for on the command line.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "brindle/recipe/refusals.h"

namespace brindle::tool {

bool is_given(const CLI::App& command, const std::string& option);

/// Throws CLI::ValidationError for the first of `options` that was given: it has no effect, and
/// `why` says why. Options that the command does not have are passed over.
void refuse_given(const CLI::App& command, const std::vector<std::string>& options,
                  std::string_view why);

/// Calls `check`. An option that it refuses (RefusedOption) is wrong usage: throws
/// CLI::ValidationError.
void refuse_usage(const std::function<void()>& check);

/// The same, and hands it what was given.
void refuse_usage(const CLI::App& command, const std::function<void(const IsGiven& given)>& check);

/// Where a report comes from: `version`, `command`, `input` and `options` by their names, as they
/// were given; flags are true, and options and inputs that may be repeated are lists.
nlohmann::ordered_json invocation_of(const CLI::App& command);

}  // namespace brindle::tool
