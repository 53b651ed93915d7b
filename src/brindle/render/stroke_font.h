/// Letters as strokes of a pen.
#pragma once

#include <string_view>
#include <vector>

#include "brindle/line_drawing.h"

namespace brindle {

/// The strokes of a text (UTF-8; letters, digits and the signs of units; others are boxes) whose
/// capitals are `height` pixels high. It begins at `start`, which is on the base line.
std::vector<Stroke> text_strokes(std::string_view text, const Eigen::Vector2f& start, float height);

/// How far the text goes, in pixels.
float text_width(std::string_view text, float height);

}  // namespace brindle
