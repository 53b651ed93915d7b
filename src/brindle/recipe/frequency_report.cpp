#include "brindle/recipe/frequency_report.h"

#include <ostream>

#include "brindle/base/text.h"

namespace brindle {

std::optional<FrequencyReport> frequency_report(const std::optional<FrequencyChange>& change,
                                                const PatternQuality& quality) {
  if (!change) return std::nullopt;
  return FrequencyReport{*change, quality.spacing_error_wanted_mean, quality.branches_in_calm};
}

nlohmann::ordered_json to_json(const FrequencyReport& report) {
  const FrequencyChange& change = report.change;
  nlohmann::ordered_json json = {{"ratio_min", change.ratio_min},
                                 {"ratio_mean", change.ratio_mean},
                                 {"ratio_max", change.ratio_max},
                                 {"share_at_bounds", change.share_at_bounds},
                                 {"spacing_error_wanted_mean", report.spacing_error_wanted_mean},
                                 {"sweeps", change.sweeps},
                                 {"residual", change.residual}};
  if (report.branches_in_calm) json["branches_in_calm"] = *report.branches_in_calm;
  return json;
}

void print_frequency(std::ostream& out, const FrequencyReport& report) {
  const FrequencyChange& change = report.change;
  out << formatted(
      "yielding  frequencies times %.3f to %.3f, %.3f on average, %.1f %% at the bounds; spacing "
      "%.1f %% from that asked for\n",
      change.ratio_min, change.ratio_max, change.ratio_mean, 100 * change.share_at_bounds,
      100 * report.spacing_error_wanted_mean);
  if (report.branches_in_calm)
    out << formatted("calm      %zu branches\n", *report.branches_in_calm);
}

}  // namespace brindle
