/// Frames of an animation in a style.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "brindle/image.h"
#include "brindle/renderer.h"
#include "input/carried_pattern.h"
#include "input/wave_options.h"
#include "jobs/animation.h"
#include "pictures/picture.h"
#include "pictures/style_options.h"

namespace brindle::tool {

/// What is to be said of a frame.
struct FrameNotes {
  std::string nothing_left;  ///< the reason why it shows nothing (`slice_refusal`); else empty
  std::string few_tiles;     ///< `tile_warning`
};

/// Draws frame after frame.
class FramePainter {
 public:
  virtual ~FramePainter() = default;

  /// The next frame, with the camera of the first one.
  virtual Image paint(const SolvedFrame& frame) = 0;

  /// Of the last frame.
  virtual FrameNotes notes() const = 0;
};

/// Points of a frame, as in the paper's Fig. 1: orange and blue for two vortex cores.
inline constexpr Color kPointColors[] = {{0.91f, 0.45f, 0.13f}, {0.16f, 0.50f, 0.84f}};

/// The look of frames.
struct FrameStyle {
  StyleOptions style;
  std::optional<TextureTile> tile;  ///< a texture instead of stripes
  bool oriented = false;            ///< for textures: directions have signs
  std::optional<bool> whole_tiles;  ///< empty: the tile's default
  WaveOptions waves;
  AnimatorOptions animator;  ///< of crossing strokes and textures
  MatchOptions match;
  int frames_per_second = 30;
  ProgressDisplay& display;
};

/// Needs a current OpenGL context. The arguments must outlive the result. Ranges of values and the
/// camera are those of the first frame. Throws Error, also later, if values or other surfaces
/// cannot be read.
std::unique_ptr<FramePainter> make_styled_frames(const FrameStyle& style,
                                                 const PictureOptions& picture);

}  // namespace brindle::tool
