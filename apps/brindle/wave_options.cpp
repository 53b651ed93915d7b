#include "wave_options.h"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <string_view>
#include <vector>

#include "array_source.h"
#include "brindle/array_field.h"
#include "brindle/base/suggestion.h"
#include "brindle/curvature.h"
#include "brindle/files.h"
#include "brindle/frequency_field.h"
#include "brindle/smooth_field.h"
#include "brindle/tensor_field.h"
#include "brindle/waves/orientation.h"
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

struct Field {
  DirectionField directions;
  FrequencyField frequencies;    // empty if the field says nothing of them
  FrequencyField frequencies_v;  // the same of crossing stripes
  std::optional<std::size_t> rows_nonfinite = {};
  MissingWaves missing = {};
  std::string notes = {};
};

bool is_smooth(const WaveOptions& options) {
  return !options.direction && (options.field == "smooth" || options.field == "curvature");
}

float curvature_anchor(const WaveOptions& options) {
  return options.curvature_anchor.value_or(options.field == "curvature" ? kDefaultCurvatureAnchor
                                                                        : 0);
}

Field read_field(const Surface& surface, const WaveOptions& options,
                 std::span<const Index> vertex_of_row) {
  FieldFile file = read_field_csv(options.field, surface.mesh.vertex_count(), vertex_of_row);
  const auto nonfinite = std::count_if(file.vectors.begin(), file.vectors.end(),
                                       [](const Vec3& vector) { return !vector.allFinite(); });
  return {tangent_directions(file.vectors, surface.normals), std::move(file.frequencies),
          std::move(file.frequencies_v), static_cast<std::size_t>(nonfinite)};
}

std::string name_of(TensorAxis axis) {
  return axis == TensorAxis::major ? "major" : axis == TensorAxis::minor ? "minor" : "max-abs";
}

Field tensor_field(const Surface& surface, const DataArray& array, const ArrayOptions& options) {
  const TensorAxis axis = options.tensor.value_or(TensorAxis::major);
  TensorField tensor = tensor_field_of(surface, array, axis);
  Field field{std::move(tensor.directions), {}, {}};
  field.missing.tensor = MissingTensorWaves{tensor.near_normal, tensor.isotropic};
  if (!options.tensor) {
    field.notes += "the array '" + array.name + "' is a tensor: waves run along its " +
                   name_of(axis) + " axis; --tensor chooses\n";
  }
  if (tensor.not_symmetric > 0) {
    field.notes += std::to_string(tensor.not_symmetric) + " rows of the tensor '" + array.name +
                   "' are not symmetric: their symmetric part counts\n";
  }
  return field;
}

Field array_field(const Surface& surface, const WaveOptions& options, const ArraySource& arrays) {
  const auto [array, rows_nonfinite] = arrays.array(parse_array("--field", options.field));
  Field field;
  if (is_tensor(array)) {
    field = tensor_field(surface, array, options.arrays);
  } else if (options.arrays.tensor) {
    throw CLI::ValidationError("--tensor", "has no effect here: the array '" + array.name +
                                               "' has " + std::to_string(array.components) +
                                               " numbers in a row, and is no tensor");
  } else {
    field.directions = direction_field_of(surface, array);
  }
  field.rows_nonfinite = rows_nonfinite;
  return field;
}

Field make_field(const Surface& surface, const WaveOptions& options, const FileData& data,
                 const ArraySource& arrays) {
  if (options.direction)
    return {projected_direction_field(*options.direction, surface.normals), {}, {}};
  if (is_smooth(options)) {
    SmoothFieldOptions smooth;
    smooth.symmetry = options.cross ? 4 : 2;
    smooth.curvature_anchor = curvature_anchor(options);
    smooth.curvature_direction = options.curvature_direction;
    smooth.feature_anchor = options.feature_anchor;
    smooth.feature_angle_deg = options.feature_angle_deg;
    return {smooth_direction_field(surface, smooth), {}, {}};
  }
  if (options.field == "raw-curvature") {
    const auto curvatures =
        principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood);
    DirectionField directions = curvature_direction_field(curvatures, options.curvature_direction);
    // The solvers are faster where few neighbours run against each other.
    orient_alike(*surface.neighborhood, directions);
    return {std::move(directions), {}, {}};
  }
  if (is_array(options.field)) return array_field(surface, options, arrays);
  return read_field(surface, options, data.vertex_of_row);
}

// What options say goes before what the field says.
void choose_frequencies(const Surface& surface, const WaveOptions& options,
                        const ArraySource& arrays, Field& field) {
  const ArrayOptions& wanted = options.arrays;
  if (wanted.frequency.empty() && wanted.frequency_by.empty()) {
    if (!field.frequencies.empty() && !options.stripes && !options.frequency) return;
    field.frequencies = constant_frequency_field(constant_frequency(surface.mesh, options),
                                                 surface.mesh.vertex_count());
  } else if (!wanted.frequency.empty()) {
    field.frequencies = frequencies_of(arrays.array(wanted.frequency).array, field.directions);
  } else {
    field.frequencies = frequencies_by(surface, arrays.array(wanted.frequency_by).array,
                                       constant_frequency(surface.mesh, options), wanted.range);
  }
  field.frequencies_v.clear();
}

// Waves of arrays that are not everywhere.
void drop_waves(const ArrayOptions& options, Field& field) {
  if (options.frequency.empty() && options.frequency_by.empty()) return;
  field.missing.without_frequency =
      drop_waves_without_frequency(field.directions, field.frequencies);
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
         (is_array(options.field) || !arrays.frequency.empty() || !arrays.frequency_by.empty());
}

void check_field_options(const CLI::App& command, const WaveOptions& options) {
  check_field_name(options);
  check_array_options(command, options.arrays, !options.direction && is_array(options.field));
  if (options.cross) {
    refuse_given(command, {"--along"}, "a cross turned by 90 degrees is the same cross");
  }
  if (!is_smooth(options)) {
    refuse_given(command, {"--curvature-anchor", "--feature-anchor", "--feature-angle"},
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
    refuse_given(command, {"--feature-angle"},
                 "nothing draws the field to sharp edges; add --feature-anchor");
  }
}

void refuse_triangle_options(const CLI::App& command) {
  refuse_given(command, {"--feature-anchor", "--weights"}, "points have no triangles");
}

float constant_frequency(const Mesh& mesh, const WaveOptions& options) {
  if (options.frequency) return *options.frequency;
  return frequency_of_stripes(options.stripes.value_or(kDefaultStripes),
                              bounding_box(mesh).diagonal());
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
         "file with one row a vertex: x,y,z, x,y,z,frequency or x,y,z,frequency,frequency_v")
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
          ->needs(texture)
          ->excludes(cross);
  add_parsed_option(app, "--frequency-v", options.frequency_v, parse_positive_number,
                    "texture: tiles across the field per unit length, instead of --stripes-v")
      ->type_name("F")
      ->needs(texture)
      ->excludes(cross)
      ->excludes(stripes);
}

WavesAndCrossing make_waves(const Surface& surface, const WaveOptions& options,
                            const FileData& data) {
  const ArraySource arrays(surface, data.arrays, data.name, options.arrays);
  Field field = make_field(surface, options, data, arrays);
  const float turn_deg = options.rotate_deg + (options.along ? 90.0f : 0.0f);
  if (turn_deg != 0) {
    field.directions =
        rotated(field.directions, surface.normals, turn_deg * std::numbers::pi_v<float> / 180);
  }
  field.missing.too_far = arrays.drop_too_far(field.directions);
  choose_frequencies(surface, options, arrays, field);
  drop_waves(options.arrays, field);
  const auto everywhere = [&](float frequency) {
    return constant_frequency_field(frequency, surface.mesh.vertex_count());
  };
  if (options.frequency_v) field.frequencies_v = everywhere(*options.frequency_v);
  if (options.stripes_v) {
    field.frequencies_v =
        everywhere(frequency_of_stripes(*options.stripes_v, bounding_box(surface.mesh).diagonal()));
  }
  return {{surface.mesh.positions, std::move(field.directions), std::move(field.frequencies)},
          std::move(field.frequencies_v),
          field.rows_nonfinite,
          field.missing,
          arrays.notes() + field.notes};
}

}  // namespace brindle::tool
