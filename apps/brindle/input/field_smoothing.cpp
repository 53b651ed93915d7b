#include "input/field_smoothing.h"

#include <string>
#include <utility>
#include <vector>

#include "brindle/arrays.h"
#include "brindle/recipe/refusals.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"

namespace brindle::tool {
namespace {

constexpr const char* kLength = "length";
constexpr const char* kAnisotropy = "anisotropy";

std::string parse_weight_value(const std::string& option, const std::string& text) {
  if (is_array(text)) {
    parse_array(option, text);
  } else if (!is_own_weight(text) && value_file(text).empty()) {
    wrong_usage(option, "one of array:NAME|FILE.csv[:COLUMN]|length|anisotropy", text);
  }
  return text;
}

}  // namespace

void add_field_smoothing_options(CLI::App& app, FieldSmoothingChoice& choice) {
  add_fields(app, choice);
  add_parsed_option(app, kWeightOption, choice.weight, parse_weight_value);
}

bool is_own_weight(const std::string& weight) {
  return weight.empty() || weight == kLength || weight == kAnisotropy;
}

FieldSmoothingOptions smoothing_options(const FieldSmoothingChoice& choice, int symmetry) {
  FieldSmoothingOptions options;
  options.periods = choice.periods;
  options.symmetry = symmetry;
  if (choice.fill) options.fill = *choice.fill;
  options.memory = choice.memory;
  options.hold_out = choice.hold_out;
  if (choice.singularities) options.singularities = static_cast<std::size_t>(*choice.singularities);
  return options;
}

FrequencySmoothingOptions frequency_smoothing_options(const FieldSmoothingChoice& choice) {
  FrequencySmoothingOptions options;
  options.periods = choice.frequency_periods;
  if (choice.fill) options.fill = *choice.fill;
  return options;
}

}  // namespace brindle::tool
