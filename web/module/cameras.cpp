#include <emscripten/bind.h>

#include "brindle/camera.h"
#include "brindle/mesh.h"
#include "objects.h"

namespace brindle::web {
namespace {

/// The camera of the tool's --camera.
val camera_of(const SurfaceObject& object, val given) {
  return guarded([&] {
    CameraView view;
    view.azimuth_deg = float_of(given, "azimuth");
    view.elevation_deg = float_of(given, "elevation");
    view.zoom = float_of(given, "zoom");
    view.up = text_of(given, "up") == "z" ? UpAxis::z : UpAxis::y;
    const Camera camera = framed_camera(points_of_triangles(object.surface.mesh), view,
                                        int_of(given, "width"), int_of(given, "height"));
    const auto numbers = [](const Eigen::Matrix4f& matrix) {
      return array_of(std::span<const float>(matrix.data(), 16));
    };
    const Vec3 up = camera.view_from_world.col(view.up == UpAxis::z ? 2 : 1).head<3>();
    val result = val::object();
    put(result, "viewFromWorld", numbers(camera.view_from_world));
    put(result, "clipFromView", numbers(camera.clip_from_view));
    put(result, "up", array_of(std::span<const float>(up.data(), 3)));
    return result;
  });
}

}  // namespace

void bind_cameras() { emscripten::function("camera", &camera_of); }

}  // namespace brindle::web
