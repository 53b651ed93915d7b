/// Options given on the command line.
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

/// Throws CLI::ValidationError for the first of `options` that was given; `why` gives the reason
/// that it has no effect. Skips options that only other commands have; throws Error for names that
/// no command has.
void refuse_given(const CLI::App& command, const std::vector<std::string>& options,
                  std::string_view why);

/// Calls `check`, and throws CLI::ValidationError for an option that it rejects (RefusedOption).
void refuse_usage(const std::function<void()>& check);

/// The same, with access to the given options.
void refuse_usage(const CLI::App& command, const std::function<void(const IsGiven& given)>& check);

/// The origin of a report: `version`, `command`, `input` and the given `options` by name. Flags are
/// true; repeatable options and inputs are lists.
nlohmann::ordered_json invocation_of(const CLI::App& command);

}  // namespace brindle::tool
