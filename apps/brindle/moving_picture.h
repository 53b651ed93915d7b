/// The frames of an animation as pictures. A build without OpenGL draws nothing.
#pragma once

#include <memory>
#include <vector>

#include "animation.h"
#include "frame_output.h"
#include "picture.h"

namespace brindle::tool {

/// Draws frame after frame, from where the camera framed the first one, and writes each as a
/// picture and into videos, as `outputs` say. Meshes may change.
class MovingPicture {
 public:
  /// Draws in a context of its own, or in the one that is current. Throws Error in a build without
  /// OpenGL, if no OpenGL context is to be had, or if a video cannot be begun.
  MovingPicture(std::vector<FrameOutput> outputs, const PictureOptions& options,
                int frames_per_second, bool own_context);
  ~MovingPicture();

  /// Draws the next frame, and its points as marks, and writes it.
  void add(const SolvedFrame& frame);

  /// Ends a video; without it nothing of it stays.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brindle::tool
