/// Draws strokes that guide the field.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/picking.h"
#include "session/singularities.h"
#include "window/base/live_session.h"
#include "window/picture/picture_place.h"
#include "window/picture/stroke_curve.h"

namespace brindle::tool {

enum class Tool { look, light, comb, spline, move, erase, steer };
inline constexpr int kToolCount = 7;

/// The tools for the picture besides the camera. Strokes are drawn, moved and erased by session
/// commands, so that the field follows the mouse and everything is one undo step.
class StrokeTool {
 public:
  StrokeTool(LiveSession& live, WindowLog& log) : live_(live), log_(log) {}

  Tool tool() const { return tool_; }
  /// Whether the tool draws strokes, instead of moving the camera or the light.
  bool draws() const { return tool_ != Tool::look && tool_ != Tool::light; }
  void choose(Tool tool);

  /// Draws tools, radius and strength as a row of widgets.
  void draw_bar();

  /// The height of the bar with the largest tool, so that pictures keep their size.
  float bar_height() const;

  /// Events of the left button on the picture: press, motion along these pixels, release.
  void press(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void drag(const PicturePlace& place, const std::vector<Eigen::Vector2d>& pixels);
  void release();

  /// Completes the spline that is being drawn. False if there is none.
  bool finish_spline();

  /// Erases the selected stroke. False if there is none.
  bool erase_chosen();

  /// The outcome of the last drag of a singularity, for the status line. Empty once undone.
  std::string status() const {
    return live_.document().steering == said_of_ ? status_ : std::string();
  }

  /// Draws strokes, singularities and the tool's radius over the picture.
  void draw_over(ImDrawList& list, const PicturePlace& place, bool hovered);

 private:
  /// A singularity being dragged, with the state before.
  struct Steering {
    FieldSingularity singularity;
    std::shared_ptr<const LiveState> state;
    DirectionField directions;  ///< of the field itself
    std::vector<FieldStroke> held;
    std::optional<std::size_t> to = {};  ///< last target triangle
    bool meets = false;                  ///< a singularity of the opposite sign is there
    std::string why_not = {};            ///< the reason why it does not follow the mouse
  };
  /// A released singularity, until the field is solved.
  struct Dropped {
    DroppedSingularity what;
    double reach;
    std::uint64_t revision;  ///< of the session
    bool is_led_on = false;  ///< a second time, from where it arrived
  };
  struct Moving {
    Points points;
    Eigen::Vector2d from;  // pixels
  };

  std::vector<Eigen::Vector2d> line_of(const PicturePlace& place, const FieldStroke& stroke) const;
  std::optional<std::size_t> stroke_at(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void set_points(Points points);
  void extend_comb(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void comb_to(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void set_comb();
  void end_comb();
  void add_control(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void move_chosen(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void erase_at(const PicturePlace& place, const Eigen::Vector2d& pixel);
  const FieldSingularity* singularity_at(const PicturePlace& place,
                                         const Eigen::Vector2d& pixel) const;
  void begin_steering(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void steer(const PicturePlace& place, const Eigen::Vector2d& pixel);
  void lead(const FieldSingularity& singularity, std::size_t to);
  void drop_singularity();
  void note_arrival(const SessionFrame& frame);
  void say(std::string status);
  double steering_reach() const;
  DirectionField field_directions(const LiveState& state) const;
  Points on_surface(const PicturePlace& place, const Points& points,
                    const Eigen::Vector2d& shift) const;
  void draw_sliders();
  void draw_along();
  void draw_let_go();
  void change_strokes(ValueChange change, float radius, float strength);
  void draw_strokes(ImDrawList& list, const PicturePlace& place);
  void draw_singularities(ImDrawList& list, const PicturePlace& place);
  void draw_cursor(ImDrawList& list, const PicturePlace& place);
  void note_frame(const SessionFrame& frame);

  LiveSession& live_;
  WindowLog& log_;
  Tool tool_ = Tool::look;
  float radius_ = 8;  // per cent of the surface's diagonal
  float strength_ = 1;
  bool show_singularities_ = false;

  Points comb_;                        // of the stroke that is being drawn
  Eigen::Vector2d combed_{0, 0};       // the pixel of its last point
  Points controls_;                    // of the spline that is being drawn
  std::optional<std::size_t> drawn_;   // the stroke that they are
  std::optional<std::size_t> chosen_;  // the stroke that is moved
  std::optional<Moving> moving_;
  std::optional<Steering> steering_;
  std::optional<Dropped> dropped_;
  std::string status_;
  std::vector<FieldStroke> said_of_;  // the steering strokes that `status_` is about
  Eigen::Vector2d last_pixel_{0, 0};
  bool refused_ = false;  // until the button is released
  std::shared_ptr<const StripeJob> noted_;
  std::vector<FieldSingularity> singularities_;
  double diagonal_ = 0;
};

}  // namespace brindle::tool
