/// Colours in files.
#pragma once

#include <algorithm>
#include <cmath>

namespace brindle {

/// A colour's level as files store it: 0 to 1 becomes 0 to 255; what is no number becomes 0.
inline unsigned char color_byte(float level) {
  return static_cast<unsigned char>(std::lround(255 * (level > 0 ? std::min(level, 1.0f) : 0.0f)));
}

}  // namespace brindle
