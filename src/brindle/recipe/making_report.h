/// What became of the maker's wishes, for reports and for people.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "brindle/pattern_of.h"

namespace brindle {

/// Keys for a report, and lines for people.
void add_to_json(const MakingFigures& figures, nlohmann::ordered_json& json);
std::string lines_of(const MakingFigures& figures);

}  // namespace brindle
