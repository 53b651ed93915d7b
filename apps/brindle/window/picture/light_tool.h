/// Moves the light of the picture with the mouse.
#pragma once

#include <imgui.h>

#include "window/base/live_session.h"
#include "window/picture/picture_place.h"

namespace brindle::tool {

/// The light direction of the document's pictures.
LightDirection light_of(const SessionDocument& document);

/// While the left button is down, the light follows the mouse as if on a ball, by the option
/// --light-from, in one undo step.
class LightTool {
 public:
  LightTool(LiveSession& live, WindowLog& log) : live_(live), log_(log) {}

  /// Call it while the button is down and the tool is selected, with the mouse motion in Dear ImGui
  /// units.
  void drag(const PicturePlace& place, const ImVec2& motion);

  /// Draws a ball with the light in the upper right corner of the picture.
  void draw_over(ImDrawList& list, const ImVec2& corner) const;

 private:
  LiveSession& live_;
  WindowLog& log_;
};

}  // namespace brindle::tool
