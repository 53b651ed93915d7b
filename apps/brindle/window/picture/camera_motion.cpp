#include "window/picture/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brindle::tool {
namespace {

constexpr float kDegreesPerHeight = 240;
constexpr float kZoomPerClick = 1.12f;
constexpr float kLeastZoom = 0.01f;
constexpr float kMostZoom = 10000;
constexpr float kDegree = std::numbers::pi_v<float> / 180;

}  // namespace

CameraView turned(const CameraView& view, const Eigen::Vector2f& motion) {
  CameraView result = view;
  if (view.rotation) {
    // About the axis across the motion, in view coordinates.
    const Vec3 axis(motion.y(), motion.x(), 0);
    const float angle = axis.norm() * kDegreesPerHeight * kDegree;
    if (angle == 0) return result;
    const Eigen::Quaternionf turn(Eigen::AngleAxisf(angle, axis.normalized()));
    result.rotation = (turn * view.rotation->normalized()).normalized();
    return result;
  }
  result.azimuth_deg = std::remainder(view.azimuth_deg - motion.x() * kDegreesPerHeight, 360.0f);
  result.elevation_deg =
      std::clamp(view.elevation_deg + motion.y() * kDegreesPerHeight, -90.0f, 90.0f);
  return result;
}

LightDirection moved_light(const LightDirection& light, const Eigen::Vector2f& motion) {
  return {std::remainder(light.azimuth_deg + motion.x() * kDegreesPerHeight, 360.0f),
          std::clamp(light.elevation_deg - motion.y() * kDegreesPerHeight, -90.0f, 90.0f)};
}

CameraView zoomed_to(const CameraView& view, float zoom) {
  CameraView result = view;
  result.zoom = zoom;
  return result;
}

CameraView zoomed(const CameraView& view, float clicks) {
  CameraView result = view;
  result.zoom = std::clamp(view.zoom * std::pow(kZoomPerClick, clicks), kLeastZoom, kMostZoom);
  return result;
}

CameraView moved(const CameraView& view, const Camera& camera, const Vec3& center, PictureSize size,
                 const Eigen::Vector2f& pixels) {
  const Eigen::Vector4f seen =
      camera.view_from_world * (center - camera.origin).homogeneous().eval();
  // Half the picture's height is one unit of clip space times the distance.
  const float distance = camera.orthographic() ? 1 : -seen.z();
  const float unit = 2 * distance / (camera.clip_from_view(1, 1) * static_cast<float>(size.height));
  const Vec3 right = camera.view_from_world.block<1, 3>(0, 0).transpose();
  const Vec3 up = camera.view_from_world.block<1, 3>(1, 0).transpose();
  CameraView result = view;
  result.center = center - unit * pixels.x() * right + unit * pixels.y() * up;
  return result;
}

Vec3 place_under(const Camera& camera, PictureSize size, const Eigen::Vector2d& pixel,
                 const Vec3& near) {
  const Eigen::Vector4f seen = camera.view_from_world * (near - camera.origin).homogeneous().eval();
  const Eigen::Matrix4f& clip = camera.clip_from_view;
  // The pixel's x and y in clip space, times w.
  const float w = clip.row(3).dot(seen);
  const float x = w * static_cast<float>(2 * pixel.x() / size.width - 1);
  const float y = w * static_cast<float>(1 - 2 * pixel.y() / size.height);
  const Vec3 there((x - clip(0, 2) * seen.z() - clip(0, 3)) / clip(0, 0),
                   (y - clip(1, 2) * seen.z() - clip(1, 3)) / clip(1, 1), seen.z());
  const Eigen::Vector4f world = camera.view_from_world.inverse() * there.homogeneous().eval();
  return world.head<3>() + camera.origin;
}

Vec3 middle_of(const Camera& camera, const Vec3& near) {
  return place_under(camera, {2, 2}, {1, 1}, near);
}

CameraView freed(const CameraView& view) {
  CameraView result = view;
  if (!view.rotation) result.rotation = rotation_of(view);
  return result;
}

CameraView upright(const CameraView& view) {
  if (!view.rotation) return view;
  // Where the viewer is, seen from the surface: to the right, above and in front.
  const Vec3 side =
      upright_axes(view.up) * (view.rotation->normalized().conjugate() * Vec3::UnitZ());
  CameraView result = view;
  result.rotation.reset();
  result.elevation_deg = std::asin(std::clamp(side.y(), -1.0f, 1.0f)) / kDegree;
  result.azimuth_deg = std::atan2(side.x(), side.z()) / kDegree;
  return result;
}

CameraView with_other_projection(const CameraView& view) {
  CameraView result = view;
  result.projection = view.projection == Projection::perspective ? Projection::orthographic
                                                                 : Projection::perspective;
  return result;
}

CameraView from_side(const CameraView& view, float azimuth_deg, float elevation_deg) {
  CameraView result = view;
  result.rotation.reset();
  result.azimuth_deg = azimuth_deg;
  result.elevation_deg = elevation_deg;
  return result;
}

}  // namespace brindle::tool
