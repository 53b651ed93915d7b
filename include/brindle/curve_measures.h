/// Measures of curves for fabrication: lengths, gaps, and the area covered by lines of a given
/// width.
#pragma once

#include <cstddef>
#include <optional>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"

namespace BRINDLE_EXPORT brindle {

/// The number of curves and their lengths, in units of length.
struct CurveLengths {
  std::size_t closed = 0, open = 0;            ///< numbers of curves
  double closed_length = 0, open_length = 0;   ///< sums over curves
  double shortest = 0, mean = 0, longest = 0;  ///< of single curves; 0 if there are none
};

/// Lengths of all lines.
CurveLengths curve_lengths(const Polylines& lines);

/// Distances between neighbouring curves along the surface, on both sides, at points about a fifth
/// of 1/f apart. Gaps above 2.5/f, as beyond a boundary, are not measured.
struct CurveGaps {
  std::size_t measured = 0;                ///< number of gaps; if 0, all others are 0
  double least = 0, mean = 0, most = 0;    ///< in units of length
  double least_ratio = 0, mean_ratio = 0;  ///< times the requested f there: 1 is ideal
  double most_ratio = 0;
  /// Times the chosen frequency, which differs with spacing tolerance.
  double least_ratio_chosen = 0, mean_ratio_chosen = 0, most_ratio_chosen = 0;
};

/// Distances between neighbouring curves over 1/f of the chosen frequencies, on both sides of the
/// curves at points about a fifth of 1/f apart. Members `wanted` use the requested frequencies.
struct CurveSpacing {
  std::size_t measured = 0;            ///< number of distances
  double mean = 0;                     ///< of the ratio; 1 is ideal
  double deviation = 0;                ///< standard deviation of the ratio
  double share_within_10_percent = 0;  ///< share of ratios from 0.9 to 1.1
  double mean_wanted = 0, deviation_wanted = 0, share_within_10_percent_wanted = 0;
  CurveGaps gaps;  ///< for fabrication, with a larger reach
};

/// The share of the surface's area, 0 to 1, within half of `width` (units of length) of a curve.
/// Distances are through space, so the other side of a sheet thinner than half of the width counts
/// too. Uses 100,000 points spread evenly over the area: accurate to about 0.002. 0 for a surface
/// without area. Throws Error if the width is not finite and above zero, and Cancelled if
/// `progress` cancels.
double curve_coverage(const Mesh& mesh, const Polylines& lines, double width,
                      const Progress& progress = {});

/// Shares of the surface's area covered by lines of a given width, 0 to 1.
struct CurveCoverage {
  double once = 0;   ///< by one line or more: `curve_coverage`
  double twice = 0;  ///< within half of the width of lines on both sides
};

/// Both shares, measured and validated as in `curve_coverage`.
CurveCoverage measure_coverage(const Mesh& mesh, const Polylines& lines, double width,
                               const Progress& progress = {});

/// All measures of curves.
struct CurveMeasures {
  CurveLengths lengths;
  std::optional<CurveGaps> gaps;        ///< empty above a million points and without nanoflann
  std::optional<double> coverage;       ///< if a width was given
  std::optional<double> covered_twice;  ///< CurveCoverage::twice, if a width was given
};

}  // namespace brindle
