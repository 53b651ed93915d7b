#include "wave_options.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "brindle/base/suggestion.h"
#include "brindle/curvature.h"
#include "brindle/frequency_field.h"
#include "command_line.h"
#include "option_values.h"

namespace brindle::tool {
namespace {

constexpr float kDefaultStripes = 40;
constexpr float kDefaultCurvatureAnchor = 0.1f;  // of --field curvature

const std::vector<std::string> kMadeFields = {"smooth", "curvature", "raw-curvature"};

std::optional<CurvatureDirection> parse_curvature_direction(std::string_view name) {
  if (name == "max") return CurvatureDirection::maximum;
  if (name == "min") return CurvatureDirection::minimum;
  return std::nullopt;
}

// What neither is a field nor looks like a file.
void check_field_name(const WaveOptions& options) {
  if (is_array(options.field)) parse_array("--field", options.field);  // which may be mistyped
  const std::filesystem::path path(options.field);
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
         (is_array(options.field) || !arrays.frequency.empty() || is_array(arrays.frequency_by));
}

void check_field_options(const CLI::App& command, const WaveOptions& options) {
  check_field_name(options);
  check_array_options(command, options.arrays, options.field);
  if (options.cross) {
    refuse_given(command, {"--along"}, "a cross turned by 90 degrees is the same cross");
  }
  if (!is_smooth(options)) {
    refuse_given(command,
                 {"--curvature-anchor", "--feature-anchor", "--feature-angle", "--feature-radius",
                  "--strokes"},
                 "only --field smooth and --field curvature are drawn to anything");
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
  if (curvature_anchor(options) == 0) {
    refuse_given(command, {"--curvature-direction"},
                 "the field does not follow curvature; take --field curvature or add "
                 "--curvature-anchor");
  }
  if (options.feature_anchor == 0) {
    refuse_given(command, {"--feature-angle", "--feature-radius"},
                 "nothing draws the field to sharp edges; add --feature-anchor");
  }
}

void refuse_triangle_options(const CLI::App& command) {
  refuse_given(command, {"--feature-anchor", "--weights"}, "points have no triangles");
}

float constant_frequency(const Mesh& mesh, const WaveOptions& options) {
  return constant_frequency(bounding_box(mesh).diagonal(), options);
}

float constant_frequency(float diagonal, const WaveOptions& options) {
  if (options.frequency) return *options.frequency;
  return frequency_of_stripes(options.stripes.value_or(kDefaultStripes), diagonal);
}

CLI::Option* add_direction_option(CLI::App& app, WaveOptions& options) {
  return add_parsed_option(app, "--direction", options.direction, parse_direction,
                           "one vector for all vertices, projected into the tangent planes; "
                           "stripes run across it")
      ->type_name("X,Y,Z");
}

CLI::Option* add_along_option(CLI::App& app, WaveOptions& options) {
  return app.add_flag("--along", options.along,
                      "stripes run along the field, not across it: waves are turned by 90 degrees");
}

namespace {

CLI::Option* add_stripes_option(CLI::App& app, WaveOptions& options) {
  return add_parsed_option(app, "--stripes", options.stripes, parse_positive_number,
                           "stripes along the diagonal of the bounding box (default 40)")
      ->type_name("N");
}

// Of a field that varies from vertex to vertex.
void add_varying_frequency_options(CLI::App& app, WaveOptions& options) {
  CLI::Option* stripes = add_stripes_option(app, options);
  app.add_option_function<std::string>(
         "--frequency",
         [&options](const std::string& text) {
           if (is_array(text)) {
             options.arrays.frequency = parse_array("--frequency", text);
           } else {
             options.frequency = parse_positive_number("--frequency", text);
           }
         },
         "stripes per unit length, instead of --stripes, everywhere or in an array; all go before "
         "the frequencies of a field file")
      ->type_name("F|array:NAME")
      ->excludes(stripes);
}

}  // namespace

void add_frequency_options(CLI::App& app, WaveOptions& options) {
  CLI::Option* stripes = add_stripes_option(app, options);
  add_parsed_option(app, "--frequency", options.frequency, parse_positive_number,
                    "stripes per unit length, instead of --stripes")
      ->type_name("F")
      ->excludes(stripes);
}

void add_wave_options(CLI::App& app, WaveOptions& options) {
  CLI::Option* direction = add_direction_option(app, options);
  app.add_option(
         "--field", options.field,
         "smooth (default); curvature, the smooth field drawn to principal curvature; "
         "raw-curvature, the latter alone; array:NAME, vectors or tensors that the mesh's "
         "file has per point or per cell (array:points/NAME, array:cells/NAME); or a CSV "
         "file with one row a vertex: x,y,z, x,y,z,frequency, x,y,z,frequency,frequency_v, or "
         "columns with names (FILE.csv:NAME if they hold several vectors)")
      ->type_name("FILE|array:NAME|smooth|curvature|raw-curvature")
      ->excludes(direction);
  add_named_option(app, "--curvature-direction", options.curvature_direction,
                   parse_curvature_direction, "max|min",
                   "principal direction of the larger (default) or smaller curvature, for fields "
                   "that follow it");
  add_parsed_option(app, "--curvature-anchor", options.curvature_anchor, parse_weight,
                    "how strongly curvature attracts the smooth field (default 0: not; 0.1 with "
                    "--field curvature)")
      ->type_name("W");
  add_parsed_option(app, "--feature-anchor", options.feature_anchor, parse_weight,
                    "how strongly sharp edges and boundaries attract the smooth field, so that it "
                    "runs along them (default 0: not)")
      ->type_name("W");
  add_parsed_option(app, "--feature-angle", options.feature_angle_deg, parse_not_negative_number,
                    "bend from which an edge is sharp for --feature-anchor (default 40)")
      ->type_name("DEG");
  add_parsed_option(app, "--feature-radius", options.feature_radius, parse_positive_length,
                    "how far from edges and boundaries --feature-anchor attracts (default: at "
                    "their vertices alone)")
      ->type_name("L|P%");
  app.add_option("--strokes", options.strokes,
                 "lines that the smooth field runs along, each with points, radius and strength")
      ->type_name("FILE.json");
  add_parsed_option(app, "--rotate", options.rotate_deg, parse_number,
                    "turn the field about the normals, in degrees")
      ->type_name("DEG");
  add_along_option(app, options);
  add_varying_frequency_options(app, options);
  add_array_options(app, options.arrays);
}

CLI::Option* add_cross_option(CLI::App& app, WaveOptions& options) {
  return app.add_flag(
      "--cross", options.cross,
      "a cross field: stripes along both waves of a cross, which change places from vertex to "
      "vertex where that is smoother; shown by a texture that looks the same turned by 90 degrees "
      "(default checker)");
}

void add_crossing_frequency_options(CLI::App& app, WaveOptions& options, CLI::Option* texture,
                                    CLI::Option* cross) {
  CLI::Option* stripes =
      add_parsed_option(app, "--stripes-v", options.stripes_v, parse_positive_number,
                        "texture: tiles across the field along the diagonal (default: as along it)")
          ->type_name("N")
          ->needs(texture);
  CLI::Option* frequency =
      add_parsed_option(app, "--frequency-v", options.frequency_v, parse_positive_number,
                        "texture: tiles across the field per unit length, instead of --stripes-v")
          ->type_name("F")
          ->needs(texture)
          ->excludes(stripes);
  if (cross == nullptr) return;
  stripes->excludes(cross);
  frequency->excludes(cross);
}

}  // namespace brindle::tool
