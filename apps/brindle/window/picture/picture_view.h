/// The picture in the window, and its mouse interaction.
#pragma once

#include <memory>
#include <vector>

#include <epoxy/gl.h>

#include "session/live_picture.h"
#include "session/picking.h"
#include "window/picture/camera_motion.h"
#include "window/picture/place_handles.h"
#include "window/picture/stroke_tool.h"

namespace brindle::tool {

/// Shows the session's newest frame. The mouse turns, moves and zooms it, moves the
/// light or positions, and draws strokes.
class PictureView {
 public:
  PictureView(LiveSession& live, StrokeTool& tool, PlaceHandles& places, WindowLog& log)
      : live_(live), tool_(tool), places_(places), log_(log) {}
  ~PictureView();
  PictureView(const PictureView&) = delete;
  PictureView& operator=(const PictureView&) = delete;

  /// Fills the rest of the current Dear ImGui window, and requests pictures of that size. `trail`:
  /// mouse positions since the last call with the left button down.
  void draw(float pixels_per_unit, const std::vector<Eigen::Vector2f>& trail);

  /// The point in the middle of the picture at the surface's depth; empty before the first frame.
  std::optional<Vec3> middle() const;

 private:
  void upload();
  void note_mouse(const PicturePlace& place, bool hovered);
  void show_values(const ImVec2& corner, const ImVec2& end) const;
  void show_legend(const ImVec2& corner) const;
  void show_why_empty(const ImVec2& corner, const ImVec2& room) const;
  void show(const PicturePlace& place);
  void follow_mouse(const PicturePlace& place, const std::vector<Eigen::Vector2f>& trail);
  void follow_tool(const PicturePlace& place, const std::vector<Eigen::Vector2f>& trail);
  void follow_wheel();
  void look(const ImVec2& motion, bool moves, const PicturePlace& place);
  void centre_at(const PicturePlace& place);
  void drag_light(const PicturePlace& place, const ImVec2& motion);
  void draw_light(const ImVec2& corner) const;

  LiveSession& live_;
  StrokeTool& tool_;
  PlaceHandles& places_;
  WindowLog& log_;
  std::shared_ptr<const SessionFrame> uploaded_;
  ViewLegend legend_;  // of it
  GLuint texture_ = 0;
  int width_ = 0;  // of the texture
  int height_ = 0;
  bool drawing_ = false;                              // with the tool
  std::vector<PickedValue> under_mouse_;              // at the picked point
  Eigen::Vector2d picked_pixel_ = {-1, -1};           // its pixel
  std::shared_ptr<const SessionFrame> picked_frame_;  // its frame
};

}  // namespace brindle::tool
