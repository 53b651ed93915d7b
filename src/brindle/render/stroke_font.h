/// Letters as pen strokes.
#pragma once

#include <string_view>
#include <vector>

#include "brindle/line_drawing.h"

namespace brindle {

/// The strokes of a UTF-8 text with capitals `height` pixels high. `start` is on the base line.
/// Characters other than letters, digits and signs of units become boxes.
std::vector<Stroke> text_strokes(std::string_view text, const Eigen::Vector2f& start, float height);

/// Width of the text, in pixels.
float text_width(std::string_view text, float height);

// Tick values of an axis.

/// At least two and at most `most` multiples of 1, 2 or 5 times a power of ten between the ends.
/// The ends themselves if there are none.
std::vector<double> tick_values(double lowest, double highest, int most);

}  // namespace brindle
