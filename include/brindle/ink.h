/// Pen strokes and rectangles in finished pictures.
#pragma once

#include <span>

#include "brindle/export.h"
#include "brindle/image.h"
#include "brindle/line_drawing.h"

namespace BRINDLE_EXPORT brindle {

/// Draws strokes with round ends, `width` pixels wide, over the picture. Where strokes cross,
/// opacity applies once. An opaque stroke covers all of a pixel's light.
void ink(Image& image, std::span<const Stroke> strokes, float width, const Color& color,
         float opacity = 1);

/// Fills a rectangle whose sides may lie between pixels, in the same way.
void fill(Image& image, const Eigen::Vector2f& lower, const Eigen::Vector2f& upper,
          const Color& color, float opacity = 1);

}  // namespace brindle
