/// Metrics of the pattern and their history.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "window/base/live_session.h"

namespace brindle::tool {

class MetricPanel {
 public:
  MetricPanel(const LiveSession& live, WindowLog& log) : live_(live), log_(log) {}

  /// Draws into the current Dear ImGui window. `window_milliseconds`: the time that the window's
  /// own thread takes to draw.
  void draw(double window_milliseconds, bool dark);

  /// Whether the user requested that in the last `draw`.
  bool asks_to_solve_again() const { return asks_to_solve_again_; }

  /// Frames of the session in the last second of work.
  double frames_per_second() const;

 private:
  /// The last values of a metric, oldest first.
  struct History {
    const char* name;
    std::vector<float> values;
  };

  void note_frame();
  void draw_counts(const SessionFrame& frame);
  void draw_followed(const LiveMetrics& metrics);
  void draw_notes(const std::vector<std::string>& notes);
  void draw_times(const SessionFrame& frame, double window_milliseconds);
  void draw_histories();

  const LiveSession& live_;
  WindowLog& log_;
  bool dark_ = true;
  bool asks_to_solve_again_ = false;
  std::uint64_t noted_ = 0;
  std::deque<double> arrivals_;  // in seconds of Dear ImGui
  std::vector<History> histories_ = {{"branches", {}},
                                     {"energy", {}},
                                     {"angle error (degrees)", {}},
                                     {"milliseconds a frame", {}},
                                     {"frames a second", {}}};
};

}  // namespace brindle::tool
