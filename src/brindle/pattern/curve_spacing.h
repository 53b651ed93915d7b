/// How far neighbouring curves are apart.
#pragma once

#include "brindle/curve_measures.h"
#include "brindle/pattern/stripe_curves.h"

namespace brindle {

/// Distances between neighbouring curves over 1/f, measured on both sides of the curves at points
/// about a fifth of 1/f apart.
struct CurveSpacing {
  std::size_t measured = 0;            ///< how often a neighbour was there
  double mean = 0;                     ///< of the ratio; 1 is ideal
  double deviation = 0;                ///< standard deviation of the ratio
  double share_within_10_percent = 0;  ///< of what was measured, ratios from 0.9 to 1.1
  CurveGaps gaps;                      ///< measured farther, for makers
};

/// Distances along the surface are taken for arcs that meet the normals at both ends. A neighbour
/// is the nearest curve sideways, on the same side of the surface, within 1.6 / f; where there is
/// none (a boundary) nothing is measured. Nor is anything where it would take more than
/// `most_points` points: their number grows with the square of the frequency, that of the curves'
/// own points only with the frequency. Throws Error in a build without nanoflann.
CurveSpacing measure_curve_spacing(const WavePattern& pattern, const StripeCurves& curves,
                                   std::size_t most_points = 1'000'000);

}  // namespace brindle
