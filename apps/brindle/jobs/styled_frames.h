/// Frames of an animation in the style that was asked for.
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

/// Draws frame after frame.
class FramePainter {
 public:
  virtual ~FramePainter() = default;

  /// The next frame, seen from where the camera framed the first one.
  virtual Image paint(const SolvedFrame& frame) = 0;

  /// Why the last one shows nothing (`slice_refusal`); empty if it shows anything.
  virtual std::string nothing_left() const = 0;
};

/// Points of a frame, of the paper's Fig. 1: orange and blue for two vortex cores.
inline constexpr Color kPointColors[] = {{0.91f, 0.45f, 0.13f}, {0.16f, 0.50f, 0.84f}};

/// What frames look like.
struct FrameStyle {
  StyleOptions style;
  std::optional<TextureTile> tile;  ///< a texture instead of stripes
  bool oriented = false;            ///< the directions' signs are meant, for textures
  std::optional<bool> whole_tiles;  ///< nothing: as suits the tile
  WaveOptions waves;
  AnimatorOptions animator;  ///< of crossing strokes and textures
  MatchOptions match;
  int frames_per_second = 30;
  ProgressDisplay& display;
};

/// Needs a current OpenGL context. What it is given must outlive it. The ends of values, and what
/// the camera frames, are those of the first frame. Throws Error, also later, for values and other
/// surfaces that cannot be had.
std::unique_ptr<FramePainter> make_styled_frames(const FrameStyle& style,
                                                 const PictureOptions& picture);

}  // namespace brindle::tool
