/// Times of pictures, for `brindle bench`.
#pragma once

#include "bench/measurements.h"
#include "brindle/renderer.h"

namespace brindle::tool {

/// Pictures of a subject's first field, from OpenGL buffers to pixels in memory.
struct DrawMetrics {
  int width = 0, height = 0;  ///< pixels
  Spread visible;             ///< the visibility pass alone, interactive: the lower bound
  Spread visible_final;       ///< the same for a final picture
  Spread interactive;
  Spread final;
};

/// Throws Error without an OpenGL context.
DrawMetrics measure_draw(const Subject& subject, int width, int height,
                         const Repetitions& repetitions, const Progress& progress);

/// Repeated pictures of one quality from a turning camera, so that nothing can be reused.
Spread picture_time(const Renderer& renderer, RenderOptions options, PictureQuality quality,
                    const Repetitions& repetitions);

}  // namespace brindle::tool
