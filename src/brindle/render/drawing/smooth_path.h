/// Smooth curves through points.
#pragma once

#include <span>

#include <Eigen/Core>

#include "brindle/line_drawing.h"

namespace brindle {

/// A closed path of cubic Béziers within `tolerance` pixels of all points (Schneider 1990, Graphics
/// Gems): the first point, then two control points and the end of each segment; the last end is the
/// first point. Turns of more than 35 degrees within two thirds of a pixel stay corners. Empty for
/// fewer than three points.
Stroke smooth_closed_path(std::span<const Eigen::Vector2d> points, double tolerance);

}  // namespace brindle
