/// Results of windings, boundaries and cancelled branches, for reports and for people.
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

#include "brindle/pattern_of.h"

namespace brindle {

/// So many windings are listed for people; reports have all.
inline constexpr std::size_t kMostWindings = 12;

/// Keys for a report, and lines for people.
void add_to_json(const MakingFigures& figures, nlohmann::ordered_json& json);
std::string lines_of(const MakingFigures& figures);

/// Those lines without the windings: sums that do not add up, turns of the field and cancelled
/// branches.
std::string remarks_of(const MakingFigures& figures);

}  // namespace brindle
