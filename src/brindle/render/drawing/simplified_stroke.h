/// Strokes in the plane with fewer points.
#pragma once

#include "brindle/line_drawing.h"

namespace brindle {

/// As `simplified` does with lines in space. A closed stroke's last point is joined to its first.
Stroke simplified_stroke(const Stroke& stroke, bool closed, float tolerance);

}  // namespace brindle
