/// Moving the light of the picture by the mouse.
#pragma once

#include <imgui.h>

#include "window/base/live_session.h"
#include "window/picture/picture_place.h"

namespace brindle::tool {

/// Where the document's pictures are lit from.
LightDirection light_of(const SessionDocument& document);

/// While the left button is down, the light follows the mouse as if it were pulled over a ball: by
/// the option --light-from, in one step of undo.
class LightTool {
 public:
  LightTool(LiveSession& live, WindowLog& log) : live_(live), log_(log) {}

  /// To be called while the button is down and the tool is chosen: what the mouse has moved by, in
  /// units of Dear ImGui.
  void drag(const PicturePlace& place, const ImVec2& motion);

  /// A ball in the upper right corner of the picture, with the light on it.
  void draw_over(ImDrawList& list, const ImVec2& corner) const;

 private:
  LiveSession& live_;
  WindowLog& log_;
};

}  // namespace brindle::tool
