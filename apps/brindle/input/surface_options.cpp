#include "input/surface_options.h"

#include "brindle/base/file_names.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "cli/option_fields.h"
#include "cli/option_values.h"

namespace brindle::tool {

Lids parse_lids(const std::string& option, const std::string& text) {
  if (lower_extension(text) == ".csv") return {std::nullopt, text};
  const auto degrees = number_in<float>(text);
  if (!degrees || !(*degrees > 0 && *degrees < 90)) {
    wrong_usage(option, "degrees above 0 and below 90, or FILE.csv", text);
  }
  return {degrees, ""};
}

SurfaceFile& file_of(const SurfaceOptions& options) {
  if (!options.file || options.file->path() != options.mesh) {
    options.file = std::make_shared<SurfaceFile>(options.mesh);
  }
  return *options.file;
}

void add_surface_options(CLI::App& app, SurfaceOptions& options) {
  app.add_option("MESH", options.mesh,
                 "mesh or points, or shape:NAME of 'brindle --shapes'; see 'brindle help inputs'")
      ->required()
      ->check([](const std::string& mesh) {
        return std::string(mesh.empty() ? "expected a file or a shape, got an empty name" : "");
      });
  app.add_option("--subdivide", options.subdivide);
  app.add_flag("--rounded", options.rounded);
  add_field(app, "--crease-angle", options.crease_angle);
}

void add_point_options(CLI::App& app, SurfaceOptions& options) {
  options.visit_points(AddField(app));
}

void refuse_points(const SurfaceOptions& options, const std::string& command) {
  if (!is_points(options)) return;
  throw Error(
      shown(options.mesh) + ": points have no triangles, and 'brindle " + command +
      "' works on meshes alone; 'brindle stripe', 'compare', 'sample' and 'info' take points");
}

std::string describe_kind(const SurfaceOptions& options) {
  // CSV files never have faces.
  const bool given = options.points || is_shape(options) || lower_extension(options.mesh) == ".csv";
  return given ? "" : shown(options.mesh) + " has no faces: its vertices are taken for points\n";
}

bool is_points(const SurfaceOptions& options) {
  return options.points || (!is_shape(options) && file_of(options).is_point_cloud());
}

bool is_shape(const SurfaceOptions& options) {
  return std::string_view(options.mesh).starts_with(kShapePrefix);
}

std::string_view shape_spec(const SurfaceOptions& options) {
  return std::string_view(options.mesh).substr(kShapePrefix.size());
}

}  // namespace brindle::tool
