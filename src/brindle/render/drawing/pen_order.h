/// The order in which pens draw their strokes.
#pragma once

#include <span>

#include "brindle/line_drawing.h"

namespace brindle {

/// Reorders and reverses strokes so that pens travel little between them: from the upper left
/// corner, and then from the end of each stroke, a pen goes on at the nearest end of those left.
/// Strokes have a point or more, all finite; those of filled pens stay. Throws Cancelled if
/// `progress` cancels.
void order_strokes(std::span<Pen> pens, const Progress& progress = {});

}  // namespace brindle
