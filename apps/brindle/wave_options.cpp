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
  FrequencyField frequencies;    // empty if the field says nothing of them
  FrequencyField frequencies_v;  // the same of crossing stripes
};

Field make_field(const Surface& surface, const WaveOptions& options,
                 std::span<const Index> vertex_of_row) {
  if (options.direction)
    return {projected_direction_field(*options.direction, surface.normals), {}, {}};
  if (options.field == "smooth") {
    SmoothFieldOptions smooth;
    smooth.symmetry = options.cross ? 4 : 2;
    smooth.curvature_anchor = options.curvature_anchor;
    smooth.curvature_direction = options.curvature_direction;
    smooth.feature_anchor = options.feature_anchor;
    smooth.feature_angle_deg = options.feature_angle_deg;
    return {smooth_direction_field(surface, smooth), {}, {}};
  }
  if (options.field == "curvature") {
    const auto curvatures =
        principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood);
    DirectionField directions = curvature_direction_field(curvatures, options.curvature_direction);
    // The solvers are faster where few neighbours run against each other.
    orient_alike(*surface.neighborhood, directions);
    return {std::move(directions), {}, {}};
  }
  FieldFile file = read_field_csv(options.field, surface.mesh.vertex_count(), vertex_of_row);
  return {tangent_directions(file.vectors, surface.normals), std::move(file.frequencies),
          std::move(file.frequencies_v)};
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
                 "smooth (default), curvature, or a CSV file with one row a vertex: x,y,z, "
                 "x,y,z,frequency or x,y,z,frequency,frequency_v")
      ->type_name("FILE|curvature|smooth")
      ->excludes(direction);
  add_named_option(app, "--curvature-direction", options.curvature_direction,
                   curvature_direction_of, "max|min",
                   "principal direction of the larger (default) or smaller curvature");
  add_parsed_option(app, "--curvature-anchor", options.curvature_anchor, not_negative_number_of,
                    "how strongly curvature attracts the smooth field (default 0: not)")
      ->type_name("W");
  add_parsed_option(app, "--feature-anchor", options.feature_anchor, not_negative_number_of,
                    "how strongly sharp edges and boundaries attract the smooth field, so that it "
                    "runs along them (default 0: not)")
      ->type_name("W");
  add_parsed_option(app, "--feature-angle", options.feature_angle_deg, not_negative_number_of,
                    "bend from which an edge is sharp (default 40)")
      ->type_name("DEG");
  add_parsed_option(app, "--rotate", options.rotate_deg, number_of,
                    "turn the field about the normals, in degrees")
      ->type_name("DEG");
  add_frequency_options(app, options);
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
      add_parsed_option(app, "--stripes-v", options.stripes_v, positive_number_of,
                        "texture: tiles across the field along the diagonal (default: as along it)")
          ->type_name("N")
          ->needs(texture)
          ->excludes(cross);
  add_parsed_option(app, "--frequency-v", options.frequency_v, positive_number_of,
                    "texture: tiles across the field per unit length, instead of --stripes-v")
      ->type_name("F")
      ->needs(texture)
      ->excludes(cross)
      ->excludes(stripes);
}

WavesAndCrossing make_waves(const Surface& surface, const WaveOptions& options,
                            std::span<const Index> vertex_of_row) {
  Field field = make_field(surface, options, vertex_of_row);
  if (options.rotate_deg != 0) {
    field.directions = rotated(field.directions, surface.normals,
                               options.rotate_deg * std::numbers::pi_v<float> / 180);
  }
  const auto everywhere = [&](float frequency) {
    return constant_frequency_field(frequency, surface.mesh.vertex_count());
  };
  if (field.frequencies.empty() || options.stripes || options.frequency) {
    field.frequencies = everywhere(constant_frequency(surface.mesh, options));
    field.frequencies_v.clear();
  }
  if (options.frequency_v) field.frequencies_v = everywhere(*options.frequency_v);
  if (options.stripes_v) {
    field.frequencies_v =
        everywhere(frequency_of_stripes(*options.stripes_v, bounding_box(surface.mesh).diagonal()));
  }
  return {{surface.mesh.positions, std::move(field.directions), std::move(field.frequencies)},
          std::move(field.frequencies_v)};
}

}  // namespace brindle::tool
