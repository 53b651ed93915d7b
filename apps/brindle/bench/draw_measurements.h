/// Times of pictures, for `brindle bench`.
#pragma once

#include "bench/measurements.h"

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

}  // namespace brindle::tool
