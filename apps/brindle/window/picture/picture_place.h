/// The position of the picture in the window.
#pragma once

#include <imgui.h>

#include "session/picking.h"
#include "session/session_worker.h"
#include "window/base/window_log.h"

namespace brindle::tool {

/// Converts between Dear ImGui units and pixels of the shown picture.
struct PicturePlace {
  ImVec2 corner;  ///< upper left, units
  float pixels_per_unit = 1;
  PictureSize size;  ///< pixels
  const SessionFrame* frame = nullptr;

  Eigen::Vector2d pixel(const ImVec2& at) const {
    return {(at.x - corner.x) * pixels_per_unit, (at.y - corner.y) * pixels_per_unit};
  }
  /// The surface under a pixel, if any.
  std::optional<PickedPoint> pick(const Eigen::Vector2d& pixel) const {
    return tool::pick(frame->surface(), frame->camera, size.width, size.height, pixel.x(),
                      pixel.y());
  }
  /// The pixel of a position relative to the mesh's origin; empty behind the viewer.
  std::optional<Eigen::Vector2d> pixel_of(const Vec3& position) const {
    return place_in_picture(position, frame->camera, size.width, size.height);
  }
  /// The same in file coordinates.
  std::optional<Eigen::Vector2d> pixel_of_place(const Eigen::Vector3d& place) const {
    return pixel_of((place - frame->surface().mesh.origin).cast<float>());
  }
  /// The log's rectangle of a round item.
  static WidgetPlace around(const ImVec2& middle, float radius) {
    const auto side = static_cast<int>(2 * radius);
    return {static_cast<int>(middle.x - radius), static_cast<int>(middle.y - radius), side, side};
  }
  ImVec2 unit(const Eigen::Vector2d& at) const {
    return {corner.x + static_cast<float>(at.x()) / pixels_per_unit,
            corner.y + static_cast<float>(at.y()) / pixels_per_unit};
  }
};

}  // namespace brindle::tool
