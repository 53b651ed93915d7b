/// Limits on the size of drawings.
#pragma once

#include <string>

#include "brindle/error.h"

namespace brindle {

/// Throws Error if a side is not in 1 .. 8192 pixels.
inline void check_drawing_size(int width, int height) {
  if (width >= 1 && height >= 1 && width <= 8192 && height <= 8192) return;
  throw Error("a drawing has 1 to 8192 pixels along each side, not " + std::to_string(width) + "x" +
              std::to_string(height));
}

}  // namespace brindle
