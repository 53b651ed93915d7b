#include "brindle/shapes.h"

#include <emscripten/bind.h>

#include "objects.h"

namespace brindle::web {
namespace {

std::shared_ptr<SurfaceObject> surface_from_shape(std::string spec, float crease_angle) {
  return guarded([&] { return surface_object(make_shape(spec), crease_angle, {}); });
}

}  // namespace

void bind_shapes() {
  using namespace emscripten;
  function("surfaceFromShape", &surface_from_shape);
  function("shapeNames", optional_override([] { return array_of(shape_names()); }));
}

}  // namespace brindle::web
