#include "input/surface_options.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/array_numbers.h"
#include "brindle/base/file_names.h"
#include "brindle/base/memory.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/local_positions.h"
#include "brindle/mesh.h"
#include "brindle/mesh_data.h"
#include "brindle/normals.h"
#include "brindle/recipe/refusals.h"
#include "brindle/shapes.h"
#include "cli/option_fields.h"
#include "cli/option_values.h"

namespace brindle::tool {

namespace {

constexpr const char* kOption = "--lids";

std::vector<bool> marked(const std::string& file, std::size_t triangles) {
  const std::vector<DataArray> columns = read_csv_arrays(file);
  if (columns.size() != 1 || columns[0].components != 1) {
    throw Error(shown(file) + ": lids are one column of 0 and 1, and it has others");
  }
  const std::vector<double> numbers = doubles_of(columns[0].view());
  if (numbers.size() != triangles) {
    throw Error(shown(file) + ": it has " + std::to_string(numbers.size()) +
                " rows for lids, and the mesh has " + std::to_string(triangles) + " triangles");
  }
  std::vector<bool> lids;
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    if (numbers[t] != 0 && numbers[t] != 1) {
      throw Error(shown(file) + ": lids are 1 and others 0; row " + std::to_string(t + 1) +
                  " is neither");
    }
    lids.push_back(numbers[t] == 1);
  }
  return lids;
}

std::vector<bool> level(const Lids& lids, const Mesh& mesh) {
  const float least = std::cos(*lids.degrees * std::numbers::pi_v<float> / 180);
  std::vector<bool> result;
  for (const Triangle& t : mesh.triangles) {
    result.push_back(std::abs(triangle_normal(mesh, t).stableNormalized().dot(lids.up)) > least);
  }
  return result;
}

}  // namespace

Lids parse_lids(const std::string& option, const std::string& text) {
  if (lower_extension(text) == ".csv") return {std::nullopt, text};
  const auto degrees = number_in<float>(text);
  if (!degrees || !(*degrees > 0 && *degrees < 90)) {
    wrong_usage(option, "degrees above 0 and below 90, or FILE.csv", text);
  }
  return {degrees, ""};
}

void leave_out(const Lids& lids, LoadedMesh& loaded) {
  Mesh& mesh = loaded.mesh;
  const std::vector<bool> out =
      lids.degrees ? level(lids, mesh) : marked(lids.file, mesh.triangle_count());
  std::vector<Index> kept;
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < out.size(); ++t) {
    if (out[t]) continue;
    kept.push_back(static_cast<Index>(t));
    triangles.push_back(mesh.triangles[t]);
  }
  if (kept.size() == out.size()) {
    throw Error(std::string(kOption) + ": no face is a lid; take a larger angle or leave it out");
  }
  if (kept.empty())
    throw Error(std::string(kOption) + ": all faces are lids; take a smaller angle");
  mesh.triangles = std::move(triangles);
  loaded.arrays.cells = rows_of(loaded.arrays.cells, kept);
}

namespace {

constexpr std::string_view kShapePrefix = "shape:";

Mesh make_named_shape(const SurfaceOptions& options, const Progress& progress) {
  try {
    return make_shape(shape_spec(options), progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const TooLarge&) {
    throw;  // correct usage, but too little memory
  } catch (const Error& error) {
    throw CLI::ValidationError("MESH", error.what());
  }
}

/// A missing file may be the name of a shape.
void check_exists(const SurfaceOptions& options) {
  std::error_code ignored;
  if (is_shape(options) || std::filesystem::exists(options.mesh, ignored)) return;
  const std::string shape = nearest(options.mesh.substr(0, options.mesh.find(',')), shape_names());
  if (shape.empty()) return;
  throw Error(shown(options.mesh) + ": there is no such file; did you mean " +
              std::string(kShapePrefix) + shape + "?");
}

SurfaceFile& file_of(const SurfaceOptions& options) {
  if (!options.file || options.file->path() != options.mesh) {
    options.file = std::make_shared<SurfaceFile>(options.mesh);
  }
  return *options.file;
}

}  // namespace

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

std::string describe(const LoadedPoints& loaded) {
  return describe_origin(loaded.cloud.origin) + loaded.left_out + describe(loaded.repair);
}

std::string describe(const LoadedMesh& loaded) {
  return describe_origin(loaded.mesh.origin) + loaded.left_out + describe(loaded.repair);
}

bool is_points(const SurfaceOptions& options) {
  return options.points || (!is_shape(options) && file_of(options).is_point_cloud());
}

LoadedPoints load_points(const SurfaceOptions& options) {
  check_exists(options);
  if (options.subdivide > 0) {
    throw CLI::ValidationError("--subdivide", "points have no triangles to split");
  }
  if (options.crease_angle) {
    throw CLI::ValidationError("--crease-angle", "points have no edges");
  }
  return is_shape(options) ? make_point_cloud(make_named_shape(options, {}).positions)
                           : file_of(options).points();
}

bool is_shape(const SurfaceOptions& options) {
  return std::string_view(options.mesh).starts_with(kShapePrefix);
}

std::string_view shape_spec(const SurfaceOptions& options) {
  return std::string_view(options.mesh).substr(kShapePrefix.size());
}

LoadedSurface load_mesh(const SurfaceOptions& options, const Progress& progress) {
  if (options.neighbors) {
    throw CLI::ValidationError("--neighbors",
                               "a mesh's vertices are joined by its edges; add --points to take "
                               "them as points");
  }
  if (options.rounded && options.subdivide == 0) {
    throw CLI::ValidationError("--rounded",
                               "bends triangles that are split, and none is; try --subdivide 2");
  }
  check_exists(options);
  JobStages stages(progress, {{"reading", 3}, {"subdividing", 2}});
  const Progress reading = stages.begin("reading");
  LoadedSurface loaded;
  if (is_shape(options)) {
    loaded.mesh = make_named_shape(options, reading);
  } else {
    static_cast<LoadedMesh&>(loaded) = file_of(options).mesh(reading);
  }
  if (!options.moved.isZero(0)) translate(loaded.mesh, options.moved);
  if (options.lids) leave_out(*options.lids, loaded);
  loaded.own_vertices = loaded.mesh.vertex_count();
  if (options.subdivide > 0) {
    subdivide(loaded.mesh, loaded.arrays, options.subdivide,
              options.rounded ? Midpoints::rounded : Midpoints::straight,
              stages.begin("subdividing"));
  }
  stages.finish();
  return loaded;
}

Creases split_at_creases(const SurfaceOptions& options, LoadedSurface& loaded) {
  Creases creases =
      brindle::split_at_creases(loaded.mesh, options.crease_angle.value_or(kCreaseAngle));
  add_rows_of_copies(creases, loaded.arrays);
  return creases;
}

}  // namespace brindle::tool
