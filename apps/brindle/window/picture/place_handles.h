/// Handles for positions in options.
#pragma once

#include <optional>

#include "session/named_places.h"
#include "window/base/live_session.h"
#include "window/picture/picture_place.h"

namespace brindle::tool {

/// A handle for each origin of distances or position of another surface. It is dragged parallel to
/// the screen, or follows the mouse on the surface.
class PlaceHandles {
 public:
  PlaceHandles(LiveSession& live, WindowLog& log) : live_(live), log_(log) {}

  /// Whether the document has none.
  bool empty() const { return named_places(shown_options(live_.document())).empty(); }

  /// Whether the last dragged position, or else the first, follows the mouse.
  bool follows() const { return follows_; }
  void set_follows(bool follows) { follows_ = follows; }

  /// Handles the mouse on Dear ImGui's last item, the picture. Returns whether a press belongs to a
  /// handle.
  bool follow_mouse(const PicturePlace& place);

  void draw_over(ImDrawList& list, const PicturePlace& place);

 private:
  std::optional<std::size_t> handle_at(const PicturePlace& place,
                                       const Eigen::Vector2d& pixel) const;
  void drag(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void hover(const PicturePlace& place, const Eigen::Vector2d& pixel);
  SessionCommand moved(const NamedPlace& from, const Eigen::Vector3d& to) const;

  LiveSession& live_;
  WindowLog& log_;
  bool follows_ = false;
  bool dragging_ = false;
  std::size_t chosen_ = 0;  // index into `named_places`
};

}  // namespace brindle::tool
