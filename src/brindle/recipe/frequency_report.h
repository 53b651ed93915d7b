/// What a report says of frequencies that yield.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>

#include <nlohmann/json.hpp>

#include "brindle/quality.h"
#include "brindle/yielding_frequency.h"

namespace brindle {

/// What has become of the frequencies, for any report.
struct FrequencyReport {
  FrequencyChange change;
  double spacing_error_wanted_mean = 0;
  std::optional<std::size_t> branches_in_calm;
};

/// Nothing where there was no slack.
std::optional<FrequencyReport> frequency_report(const std::optional<FrequencyChange>& change,
                                                const PatternQuality& quality);

nlohmann::ordered_json to_json(const FrequencyReport& report);

/// A line for people.
void print_frequency(std::ostream& out, const FrequencyReport& report);

}  // namespace brindle
