#include <algorithm>

#include <emscripten/bind.h>

#include "brindle/camera.h"
#include "brindle/error.h"
#include "brindle/mesh.h"
#include "brindle/render/parsed_words.h"
#include "objects.h"

namespace brindle::web {
namespace {

/// The camera of the tool's --camera.
val camera_of(const SurfaceObject& object, const val& given) {
  CameraView view;
  view.azimuth_deg = float_of(given, "azimuth");
  view.elevation_deg = float_of(given, "elevation");
  if (const std::string side = text_of(given, "side"); !side.empty()) {
    // Without the parser of --camera, which makes the module heavier.
    const auto* seen = std::find_if(kViewSides.begin(), kViewSides.end(),
                                    [&](const ViewSide& known) { return known.name == side; });
    if (seen == kViewSides.end()) {
      throw Error("side must be one of front, back, left, right, top, bottom, not '" + side + "'");
    }
    view.azimuth_deg = seen->azimuth_deg;
    view.elevation_deg = seen->elevation_deg;
  }
  view.zoom = float_of(given, "zoom");
  if (given["orthographic"].as<bool>()) view.projection = Projection::orthographic;
  const auto up = parse_up_axis(text_of(given, "up"));
  if (!up) {
    throw Error("up must be one of x, y, z, -x, -y, -z, not '" + text_of(given, "up") + "'");
  }
  view.up = *up;
  const Camera camera = framed_camera(points_of_triangles(object.surface.mesh), view,
                                      int_of(given, "width"), int_of(given, "height"));
  const auto numbers = [](const Eigen::Matrix4f& matrix) {
    return array_of(std::span<const float>(matrix.data(), 16));
  };
  const Vec3 sky =
      camera.view_from_world.topLeftCorner<3, 3>() * upright_axes(view.up).row(1).transpose();
  val result = val::object();
  put(result, "viewFromWorld", numbers(camera.view_from_world));
  put(result, "clipFromView", numbers(camera.clip_from_view));
  const Eigen::Quaternionf rotation = rotation_of(view);
  put(result, "rotation", array_of(std::span<const float>(rotation.coeffs().data(), 4)));
  put(result, "up", array_of(std::span<const float>(sky.data(), 3)));
  return result;
}

}  // namespace

void bind_cameras() { emscripten::function("camera", guarded<camera_of>); }

}  // namespace brindle::web
