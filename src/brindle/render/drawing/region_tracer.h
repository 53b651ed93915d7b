/// Outlines of regions of a function on the plane, at sub-grid precision.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/line_drawing.h"
#include "brindle/progress.h"

namespace brindle {

/// A closed line, without repeating the first point.
using OutlineLoop = std::vector<Eigen::Vector2d>;

/// The region code at a point, in pixels from the upper left corner; 0 outside the picture.
using CodeAt = std::function<std::uint16_t(double x, double y)>;

/// A region: all points with a code in a range.
struct CodeRange {
  std::uint16_t first, last;

  bool has(std::uint16_t code) const { return first <= code && code <= last; }
};

/// Closed outlines of each region, which is on their left on the screen; holes run the other way.
/// Samples a picture at every half pixel, so that wider regions are never missed, and locates the
/// outlines by bisection: points are within a thousandth of a pixel of the change, and lines within
/// `tolerance` pixels, for outlines that do not turn within a tenth of a pixel. Calls `code_at`
/// from many threads. Throws Cancelled.
std::vector<std::vector<OutlineLoop>> region_outlines(int width, int height, const CodeAt& code_at,
                                                      std::span<const CodeRange> regions,
                                                      double tolerance, const Progress& progress);

// Smooth curves through points.

/// A closed path of cubic Béziers within `tolerance` pixels of all points (Schneider 1990, Graphics
/// Gems): the first point, then two control points and the end of each segment; the last end is the
/// first point. Turns of more than 35 degrees within two thirds of a pixel stay corners. Empty for
/// fewer than three points.
Stroke smooth_closed_path(std::span<const Eigen::Vector2d> points, double tolerance);

}  // namespace brindle
