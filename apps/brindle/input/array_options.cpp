#include "input/array_options.h"

#include <vector>

#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "input/csv_field.h"
#include "input/vertex_values.h"

namespace brindle::tool {
namespace {

constexpr std::string_view kArray = "array:";

std::string parse_frequency_value(const std::string& option, const std::string& text) {
  check_value_name(option, text);
  return text;
}

FrequencyRange parse_frequency_range(const std::string& option, const std::string& text) {
  const char* expected =
      "two factors above zero, the smaller one first, such as 0.4..2.5 or "
      "0.4..2.5,inverse or 0.01..1,reciprocal";
  const std::vector<std::string> parts = split(text, ',');
  FrequencyRange range;
  range.inverse = parts.size() == 2 && parts.back() == "inverse";
  range.reciprocal = parts.size() == 2 && parts.back() == "reciprocal";
  if (parts.size() > 1 && !range.inverse && !range.reciprocal) wrong_usage(option, expected, text);
  const auto [lowest, highest] = parse_ends(option, expected, parts.front());
  range.lowest = parse_positive_number(option, lowest);
  range.highest = parse_positive_number(option, highest);
  if (range.lowest >= range.highest) wrong_usage(option, expected, text);
  return range;
}

}  // namespace

bool is_array(std::string_view value) { return value.starts_with(kArray); }

std::string parse_array(const std::string& option, const std::string& value) {
  if (!is_array(value) || value.size() == kArray.size()) wrong_usage(option, "array:NAME", value);
  return value.substr(kArray.size());
}

void add_array_options(CLI::App& app, ArrayOptions& options) {
  add_fields(app, options);
  add_parsed_option(app, "--frequency-by", options.frequency_by, parse_frequency_value);
  add_parsed_option(app, "--frequency-range", options.range, parse_frequency_range);
}

DataArray ordered_array(const DataArray& array, const ArrayOptions& options) {
  if (!options.order) return array;
  if (*options.order == TensorOrder::vtk && !is_tensor(array)) {
    throw CLI::ValidationError("--tensor-order", "has no effect here: the array '" + array.name +
                                                     "' has " + std::to_string(array.components) +
                                                     " numbers in a row, and is no tensor");
  }
  return in_vtk_order(array, *options.order);
}

void check_array_options(const CLI::App& command, const ArrayOptions& options,
                         const std::string& field, bool is_file) {
  if (!is_array(field) && !is_file) {
    refuse_given(command, {"--tensor"},
                 "the field is no tensor; add --field array:NAME or FILE.csv:NAME");
  }
  if (!is_array(field)) {
    refuse_given(command, {"--tensor-order"},
                 "it is for --field array:NAME; in CSV files, name columns NAME:XX, NAME:YY and so "
                 "on");
  }
  if (options.frequency_by.empty()) {
    refuse_given(command, {"--frequency-range"},
                 "nothing varies the frequency; add --frequency-by VALUE");
  } else if (!options.frequency.empty()) {
    throw CLI::ValidationError("--frequency-by",
                               "--frequency array:" + options.frequency +
                                   " says all of the frequencies; leave out one of both");
  } else if (depends_on_camera(options.frequency_by) && !has_camera(command)) {
    throw CLI::ValidationError("--frequency-by", "'" + options.frequency_by +
                                                     "' depends on a picture's camera, and " +
                                                     command.get_name() + " draws none");
  }
  if (!is_array(field) && !is_array(options.frequency_by) && options.frequency.empty()) {
    refuse_given(command, {"--field-mesh"},
                 "no array is taken from it; add --field array:NAME or --frequency-by array:NAME");
  }
  if (options.mesh.empty()) {
    refuse_given(command, {"--max-distance"}, "the field is the mesh's own; add --field-mesh FILE");
  }
}

}  // namespace brindle::tool
