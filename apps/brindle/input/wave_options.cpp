#include "input/wave_options.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/arrays.h"
#include "brindle/base/text.h"
#include "brindle/frequency_field.h"
#include "brindle/normals.h"
#include "brindle/recipe/refusals.h"
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

namespace {

constexpr float kDefaultStripes = 40;
constexpr float kDefaultCurvatureAnchor = 0.1f;  // with --field curvature

const std::vector<std::string> kMadeFields = {"smooth", "curvature", "raw-curvature"};

const std::vector<std::filesystem::path> kMeshesWithArrays = {".vtp", ".vtu",  ".vtk",
                                                              ".ply", ".gltf", ".glb"};

// Rejects names that are neither fields nor files.
void check_field_name(const WaveOptions& options) {
  if (is_array(options.field)) parse_array("--field", options.field);  // rejects misspelt names
  const std::filesystem::path path(options.field);
  if (std::ranges::count(kMeshesWithArrays, path.extension()) > 0) {
    throw CLI::ValidationError("--field", "'" + options.field +
                                              "' is a mesh; for an array of it, add --field "
                                              "array:NAME --field-mesh " +
                                              options.field);
  }
  std::error_code ignored;
  if (!is_field_file(options) || path.has_extension() || std::filesystem::exists(path, ignored)) {
    return;
  }
  const std::string meant = nearest(options.field, kMadeFields);
  throw CLI::ValidationError(
      "--field", "'" + options.field +
                     "' is no file and none of smooth, curvature, raw-curvature, array:NAME" +
                     (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
}

}  // namespace

bool is_smooth(const WaveOptions& options) {
  return !options.direction && (options.field == "smooth" || options.field == "curvature");
}

float curvature_anchor(const WaveOptions& options) {
  return options.curvature_anchor.value_or(options.field == "curvature" ? kDefaultCurvatureAnchor
                                                                        : 0);
}

bool is_measured(const WaveOptions& options) { return !options.direction && !is_smooth(options); }

bool has_signs(const WaveOptions& options) { return options.oriented || options.smoothing.arrows; }

int symmetry_of(const WaveOptions& options) {
  if (options.cross) return 4;
  return options.smoothing.arrows ? 1 : 2;
}

float turn_deg(const WaveOptions& options) {
  return options.rotate_deg + (options.along ? 90.0f : 0.0f);
}

bool goes_on_from_last(const WaveOptions& options) {
  return is_smooth(options) || (is_measured(options) && options.smoothing.memory > 0);
}

bool is_field_file(const WaveOptions& options) {
  return !options.direction && !is_array(options.field) &&
         std::find(kMadeFields.begin(), kMadeFields.end(), options.field) == kMadeFields.end();
}

std::string source_of(const WaveOptions& options) {
  if (options.direction) return "the direction";
  if (is_array(options.field)) return "the array '" + parse_array("--field", options.field) + "'";
  return is_field_file(options) ? "the field '" + options.field + "'"
                                : "the " + options.field + " field";
}

bool needs_own_arrays(const WaveOptions& options) {
  const ArrayOptions& arrays = options.arrays;
  return arrays.mesh.empty() &&
         (is_array(options.field) || !arrays.frequency.empty() || is_array(arrays.frequency_by) ||
          is_array(options.smoothing.weight));
}

bool says_frequencies(const WaveOptions& options) {
  return !options.arrays.frequency.empty() || !options.arrays.frequency_by.empty();
}

bool says_one_frequency(const WaveOptions& options) {
  return options.stripes || options.frequency || options.spacing;
}

void refuse_frequency_smoothing() {
  throw CLI::ValidationError("--frequency-smoothing",
                             std::string("has no effect here: ") + kSameFrequency);
}

bool may_vary(const WaveOptions& options) {
  if (says_frequencies(options)) return true;
  return is_field_file(options) && !says_one_frequency(options);
}

void check_field_options(const CLI::App& command, const WaveOptions& options) {
  check_field_name(options);
  check_array_options(command, options.arrays, options.field, is_field_file(options));
  refuse_usage(command, [&](const IsGiven& given) {
    check_field_smoothing(given, {options.smoothing.periods, options.smoothing.frequency_periods,
                                  is_measured(options), options.cross, may_vary(options)});
  });
  if (options.cross) {
    refuse_given(command, {"--along"}, "a cross turned by 90 degrees is the same cross");
  }
  if (!is_smooth(options)) {
    refuse_given(command,
                 {"--curvature-anchor", "--feature-anchor", "--feature-angle", "--feature-radius",
                  "--strokes"},
                 "only --field smooth and --field curvature are drawn to anything");
    refuse_given(command, {"--normal-radius"},
                 "only --field smooth and --field curvature follow the bends of the surface");
    if (options.direction || options.field != "raw-curvature") {
      refuse_given(command, {"--curvature-direction"},
                   "the field does not follow curvature; --field curvature does");
    }
    return;
  }
  if (options.field == "curvature" && curvature_anchor(options) == 0) {
    throw CLI::ValidationError("--curvature-anchor",
                               "0 leaves nothing of --field curvature; take --field smooth");
  }
  refuse_usage(command, [&](const IsGiven& given) {
    check_smooth_field(given, curvature_anchor(options), options.feature_anchor);
  });
}

void refuse_triangle_options(const CLI::App& command) {
  refuse_usage(command, check_triangle_options);
}

float constant_frequency(const Mesh& mesh, const WaveOptions& options) {
  return constant_frequency(bounding_box(mesh).diagonal(), options);
}

float constant_frequency(float diagonal, const WaveOptions& options) {
  if (options.frequency) return *options.frequency;
  if (options.spacing) return frequency_of_spacing(options.spacing->on(diagonal));
  return frequency_of_stripes(options.stripes.value_or(kDefaultStripes), diagonal);
}

namespace {

void add_frequency_option(CLI::App& app, WaveOptions& options) {
  app.add_option_function<std::string>("--frequency", [&options](const std::string& text) {
    if (is_array(text)) {
      options.arrays.frequency = parse_array("--frequency", text);
    } else {
      options.frequency = parse_positive_number("--frequency", text);
    }
  });
}

}  // namespace

void add_wave_options(CLI::App& app, WaveOptions& options) {
  add_parsed_option(app, "--direction", options.direction, parse_direction);
  add_fields(app, options);
  add_frequency_option(app, options);
  add_array_options(app, options.arrays);
  add_field_smoothing_options(app, options.smoothing);
}

CLI::Option* add_cross_option(CLI::App& app, WaveOptions& options) {
  return app.add_flag("--cross", options.cross);
}

}  // namespace brindle::tool
