/// What there is to say of the pattern, in numbers and over time.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "window/base/live_session.h"

namespace brindle::tool {

class FigurePanel {
 public:
  FigurePanel(const LiveSession& live, WindowLog& log) : live_(live), log_(log) {}

  /// Into the current window of Dear ImGui. `window_milliseconds`: what the window's own thread
  /// takes to draw itself once.
  void draw(double window_milliseconds, bool dark);

  /// Whether the last `draw` was asked for that.
  bool asks_to_solve_anew() const { return asks_to_solve_anew_; }

  /// Frames of the session in the last second of work.
  double frames_per_second() const;

 private:
  /// The last values of a figure, oldest first.
  struct History {
    const char* name;
    std::vector<float> values;
  };

  void note_frame();
  void draw_counts(const SessionFrame& frame);
  void draw_followed(const LiveFigures& figures);
  void draw_notes(const std::vector<std::string>& notes);
  void draw_times(const SessionFrame& frame, double window_milliseconds);
  void draw_histories();

  const LiveSession& live_;
  WindowLog& log_;
  bool dark_ = true;
  bool asks_to_solve_anew_ = false;
  std::uint64_t noted_ = 0;
  std::deque<double> arrivals_;  // seconds of Dear ImGui
  std::vector<History> histories_ = {{"branches", {}},
                                     {"energy", {}},
                                     {"angle error (degrees)", {}},
                                     {"milliseconds a frame", {}},
                                     {"frames a second", {}}};
};

}  // namespace brindle::tool
