/// Times of pictures, for `brindle bench`.
#pragma once

#include "bench/measurements.h"
#include "brindle/renderer.h"

namespace brindle::tool {

/// Pictures of a subject's first field, from what lies in OpenGL's buffers to pixels in memory.
struct DrawFigures {
  int width = 0, height = 0;  ///< pixels
  Spread visible;             ///< which triangle is seen, for an interactive picture: the floor
  Spread visible_final;       ///< the same for a final one
  Spread interactive;
  Spread final;
};

/// Throws Error if no OpenGL context is to be had.
DrawFigures measure_draw(const Subject& subject, int width, int height,
                         const Repetitions& repetitions, const Progress& progress);

/// A picture of a given quality over and over, from a camera that turns: nothing of the last one is
/// of use.
Spread picture_time(const Renderer& renderer, RenderOptions options, PictureQuality quality,
                    const Repetitions& repetitions);

}  // namespace brindle::tool
