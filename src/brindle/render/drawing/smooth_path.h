/// Smooth curves through points.
#pragma once

#include <span>

#include <Eigen/Core>

#include "brindle/line_drawing.h"

namespace brindle {

/// A closed path of cubic Béziers that passes all points by less than `tolerance` pixels: its first
/// point, then two control points and the end of each piece; the last end is the first point
/// (Schneider 1990, Graphics Gems). It has corners where the points turn by more than 35 degrees
/// within two thirds of a pixel. Fewer than three points give nothing.
Stroke smooth_closed_path(std::span<const Eigen::Vector2d> points, double tolerance);

}  // namespace brindle
