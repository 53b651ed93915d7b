#include "surface_options.h"

#include <string_view>
#include <utility>

#include "brindle/error.h"
#include "brindle/mesh.h"
#include "brindle/shapes.h"

namespace brindle::tool {
namespace {

constexpr std::string_view kShapePrefix = "shape:";

Mesh make_named_shape(const SurfaceOptions& options) {
  try {
    return make_shape(std::string_view(options.mesh).substr(kShapePrefix.size()));
  } catch (const Error& error) {
    throw CLI::ValidationError("MESH", error.what());
  }
}

}  // namespace

void add_surface_options(CLI::App& app, SurfaceOptions& options) {
  app.add_option("MESH", options.mesh,
                 "a file (.obj .ply .stl .off .gltf .glb) or a built-in shape, such as shape:torus "
                 "or shape:torus,resolution=64,noise=0.2; 'brindle --shapes' lists them")
      ->required();
  app.add_option("--subdivide", options.subdivide, "split every triangle in four, K times")
      ->type_name("K")
      ->check(CLI::Range(0, 10));
}

void add_point_options(CLI::App& app, SurfaceOptions& options) {
  app.add_flag(
      "--points", options.points,
      "take the vertices alone, as points; files without faces (.ply, .obj, .csv with rows "
      "x,y,z or x,y,z,nx,ny,nz) are points anyway");
  app.add_option("--neighbors", options.neighbors, "points: join each to its K nearest (default 8)")
      ->type_name("K")
      ->check(CLI::Range(3, 100));
}

bool is_points(const SurfaceOptions& options) {
  return options.points || (!is_shape(options) && is_point_file(options.mesh));
}

LoadedPoints load_points(const SurfaceOptions& options) {
  if (options.subdivide > 0) {
    throw CLI::ValidationError("--subdivide", "points have no triangles to split");
  }
  return is_shape(options) ? make_point_cloud(make_named_shape(options).positions)
                           : read_points(options.mesh);
}

bool is_shape(const SurfaceOptions& options) {
  return std::string_view(options.mesh).starts_with(kShapePrefix);
}

LoadedMesh load_mesh(const SurfaceOptions& options) {
  LoadedMesh loaded =
      is_shape(options) ? LoadedMesh{make_named_shape(options), {}} : read_mesh(options.mesh);
  if (options.subdivide > 0) loaded.mesh = subdivide(std::move(loaded.mesh), options.subdivide);
  return loaded;
}

}  // namespace brindle::tool
