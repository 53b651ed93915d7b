/// The frames of an animation as pictures. A build without OpenGL draws nothing.
#pragma once

#include <memory>
#include <span>

#include "brindle/pattern/corner_phases.h"
#include "brindle/pipeline/scene.h"
#include "frame_output.h"
#include "picture.h"

namespace brindle::tool {

/// Draws and writes frame after frame, from where the camera framed the first one.
class MovingPicture {
 public:
  /// Throws Error in a build without OpenGL, if no OpenGL context is to be had, or if a video
  /// cannot be begun.
  MovingPicture(FrameOutput output, const PictureOptions& options, int frames_per_second);
  ~MovingPicture();

  /// Draws the next frame, and its points as marks, and writes it.
  void add(const SceneFrame& frame, std::span<const Complex> z,
           std::span<const CornerPhases> corners);

  /// Ends a video; without it nothing of it stays.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brindle::tool
