/// The frames of an animation as pictures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "jobs/animation.h"
#include "jobs/styled_frames.h"
#include "pictures/frame_output.h"
#include "pictures/picture.h"

namespace brindle::tool {

/// Draws frame after frame, from where the camera framed the first one, and writes each as a
/// picture and into videos, as `outputs` say. Meshes may change.
class MovingPicture {
 public:
  /// Draws in a context of its own, or in the one that is current; in a style, if there is one,
  /// which must outlive this. Throws Error in a build without OpenGL, if no OpenGL context is to be
  /// had, or if a video cannot be begun.
  MovingPicture(std::vector<FrameOutput> outputs, const PictureOptions& options,
                int frames_per_second, bool own_context, const FrameStyle* style);
  ~MovingPicture();

  /// Draws the next frame, and its points as marks; it is written while the next ones are made.
  /// Throws Error if an earlier one could not be written. Returns why nothing of the surface is
  /// seen, or nothing: surfaces that move may do so beyond a slice.
  std::string add(const SolvedFrame& frame);

  /// Waits until all frames are written and ends videos; without it nothing of a video stays.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brindle::tool
