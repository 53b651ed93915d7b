/// Reports on winding numbers, boundaries and cancelled branches.
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

#include "brindle/pattern_of.h"

namespace brindle {

/// Most winding numbers in a text report; JSON reports have all.
inline constexpr std::size_t kMostWindings = 12;

/// JSON keys, and lines of text.
void add_to_json(const FabricationMetrics& metrics, nlohmann::ordered_json& json);
std::string lines_of(const FabricationMetrics& metrics);

/// Those lines without the winding numbers: sums that do not add up, rotation of the field and
/// cancelled branches.
std::string remarks_of(const FabricationMetrics& metrics);

}  // namespace brindle
