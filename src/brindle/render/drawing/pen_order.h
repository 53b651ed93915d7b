/// The order in which pens draw their strokes.
#pragma once

#include <span>
#include <string>

#include "brindle/error.h"
#include "brindle/line_drawing.h"

namespace brindle {

/// Reorders and reverses strokes so that pens travel little between them, from the upper left
/// corner on (`nearest_order`, `shorten_travel`). Strokes have a point or more, all finite; those
/// of filled pens stay. Throws Cancelled if `progress` cancels.
void order_strokes(std::span<Pen> pens, const Progress& progress = {});

// Limits on the size of drawings.

/// Throws Error if a side is not in 1 .. 8192 pixels.
inline void check_drawing_size(int width, int height) {
  if (width >= 1 && height >= 1 && width <= 8192 && height <= 8192) return;
  throw Error("a drawing has 1 to 8192 pixels along each side, not " + std::to_string(width) + "x" +
              std::to_string(height));
}

}  // namespace brindle
