/// Radii of curves, and curves without tight bends.
#pragma once

#include "brindle/polylines.h"
#include "brindle/tool_paths.h"

namespace brindle {

/// The least radius of all lines: at each point, of the circle through it and the points `reach`
/// before and after it along the line. Infinite for straight lines.
double least_radius_of(const Polylines& lines, float reach);

struct KeptCurves {
  float least_radius = 0, reach = 0;
  float least_length = 0;
};

/// Lines, cut at the tightest point of each bend below `least_radius`, without those shorter than
/// `least_length` or without two points. Counts cuts and lines left out.
Polylines kept_curves(const Polylines& lines, const KeptCurves& kept, ToolPathMetrics& metrics);

}  // namespace brindle
