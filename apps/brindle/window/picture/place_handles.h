/// Places that options name, on the picture.
#pragma once

#include <optional>

#include "session/named_places.h"
#include "window/base/live_session.h"
#include "window/picture/picture_place.h"

namespace brindle::tool {

/// A handle for every place that a value is a distance from or another surface is moved to. It is
/// dragged parallel to the screen, or follows the mouse over the surface.
class PlaceHandles {
 public:
  PlaceHandles(LiveSession& live, WindowLog& log) : live_(live), log_(log) {}

  /// Whether the document names any.
  bool empty() const { return named_places(shown_options(live_.document())).empty(); }

  /// Whether the place that was dragged last, or else the first, is where the mouse is.
  bool follows() const { return follows_; }
  void set_follows(bool follows) { follows_ = follows; }

  /// Looks at the mouse on Dear ImGui's last item, the picture. Returns whether a press of the
  /// mouse belongs to a handle.
  bool follow_mouse(const PicturePlace& place);

  void draw_over(ImDrawList& list, const PicturePlace& place);

 private:
  std::optional<Eigen::Vector2d> pixel_of(const PicturePlace& place,
                                          const Eigen::Vector3d& at) const;
  std::optional<std::size_t> handle_at(const PicturePlace& place,
                                       const Eigen::Vector2d& pixel) const;
  void drag(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void hover(const PicturePlace& place, const Eigen::Vector2d& pixel);
  SessionCommand moved(const NamedPlace& from, const Eigen::Vector3d& to) const;

  LiveSession& live_;
  WindowLog& log_;
  bool follows_ = false;
  bool dragging_ = false;
  std::size_t chosen_ = 0;  // of `named_places`
};

}  // namespace brindle::tool
