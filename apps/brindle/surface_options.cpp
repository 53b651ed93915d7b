#include "surface_options.h"

#include <string_view>
#include <utility>

#include "brindle/base/error.h"
#include "brindle/surface/shapes.h"
#include "brindle/surface/subdivide.h"

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
