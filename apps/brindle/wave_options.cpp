#include "wave_options.h"

#include <numbers>
#include <string_view>

#include "brindle/pipeline/smooth_field.h"
#include "brindle/surface/curvature.h"
#include "brindle/waves/frequency_field.h"
#include "brindle/waves/orientation.h"
#include "option_values.h"

namespace brindle::tool {
namespace {

constexpr float kDefaultStripes = 40;

std::optional<CurvatureDirection> curvature_direction_of(std::string_view name) {
  if (name == "max") return CurvatureDirection::maximum;
  if (name == "min") return CurvatureDirection::minimum;
  return std::nullopt;
}

struct Field {
  DirectionField directions;
  FrequencyField frequencies;  // empty if the field says nothing of them
};

Field make_field(const Surface& surface, const WaveOptions& options) {
  if (options.direction)
    return {projected_direction_field(*options.direction, surface.normals), {}};
  if (options.field == "smooth") {
    SmoothFieldOptions smooth;
    smooth.curvature_anchor = options.curvature_anchor;
    smooth.curvature_direction = options.curvature_direction;
    return {smooth_direction_field(surface, smooth), {}};
  }
  if (options.field == "curvature") {
    const auto curvatures =
        principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood);
    DirectionField directions = curvature_direction_field(curvatures, options.curvature_direction);
    // The solvers are faster where few neighbours run against each other.
    orient_alike(*surface.neighborhood, directions);
    return {std::move(directions), {}};
  }
  FieldFile file = read_field_csv(options.field, surface.mesh.vertex_count());
  return {tangent_directions(file.vectors, surface.normals), std::move(file.frequencies)};
}

}  // namespace

float constant_frequency(const Mesh& mesh, const WaveOptions& options) {
  if (options.frequency) return *options.frequency;
  return frequency_of_stripes(options.stripes.value_or(kDefaultStripes),
                              bounding_box(mesh).diagonal());
}

CLI::Option* add_direction_option(CLI::App& app, WaveOptions& options) {
  return add_parsed_option(app, "--direction", options.direction, direction_of,
                           "one vector for all vertices, projected into the tangent planes")
      ->type_name("X,Y,Z");
}

void add_frequency_options(CLI::App& app, WaveOptions& options) {
  CLI::Option* stripes =
      add_parsed_option(app, "--stripes", options.stripes, positive_number_of,
                        "stripes along the diagonal of the bounding box (default 40)")
          ->type_name("N");
  add_parsed_option(app, "--frequency", options.frequency, positive_number_of,
                    "stripes per unit length, instead of --stripes; either goes before the "
                    "frequencies of a field file")
      ->type_name("F")
      ->excludes(stripes);
}

void add_wave_options(CLI::App& app, WaveOptions& options) {
  CLI::Option* direction = add_direction_option(app, options);
  app.add_option("--field", options.field,
                 "smooth (default), curvature, or a CSV file with one row a vertex: x,y,z or "
                 "x,y,z,frequency")
      ->type_name("FILE|curvature|smooth")
      ->excludes(direction);
  add_named_option(app, "--curvature-direction", options.curvature_direction,
                   curvature_direction_of, "max|min",
                   "principal direction of the larger (default) or smaller curvature");
  add_parsed_option(app, "--curvature-anchor", options.curvature_anchor, not_negative_number_of,
                    "how strongly curvature attracts the smooth field (default 0: not)")
      ->type_name("W");
  add_parsed_option(app, "--rotate", options.rotate_deg, number_of,
                    "turn the field about the normals, in degrees")
      ->type_name("DEG");
  add_frequency_options(app, options);
}

WaveSet make_waves(const Surface& surface, const WaveOptions& options) {
  Field field = make_field(surface, options);
  if (options.rotate_deg != 0) {
    field.directions = rotated(field.directions, surface.normals,
                               options.rotate_deg * std::numbers::pi_v<float> / 180);
  }
  if (field.frequencies.empty() || options.stripes || options.frequency) {
    field.frequencies = constant_frequency_field(constant_frequency(surface.mesh, options),
                                                 surface.mesh.vertex_count());
  }
  return {surface.mesh.positions, std::move(field.directions), std::move(field.frequencies)};
}

}  // namespace brindle::tool
