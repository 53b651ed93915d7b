/// The frames of an animation as pictures and videos.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "jobs/animation.h"
#include "jobs/styled_frames.h"
#include "pictures/frame_output.h"
#include "pictures/picture.h"

namespace brindle::tool {

/// Draws frames with the first one's camera and writes each to all `outputs`. Meshes may change.
class MovingPicture {
 public:
  /// Draws in the current context or in one of its own, with an optional style, which must outlive
  /// this object. Throws Error in builds without OpenGL, without a context, or if a video cannot be
  /// started.
  MovingPicture(std::vector<FrameOutput> outputs, const PictureOptions& options,
                int frames_per_second, bool own_context, const FrameStyle* style);
  ~MovingPicture();

  /// Draws the next frame, with points as marks, and writes it in the background. Throws Error if
  /// an earlier one could not be written.
  FrameNotes add(const SolvedFrame& frame);

  /// Waits for all frames and completes videos; without this call, no video file remains.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brindle::tool
