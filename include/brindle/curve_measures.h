/// What whoever makes something of curves asks for: how long they are, how far apart, and how much
/// of the surface lines of a given width cover.
#pragma once

#include <cstddef>
#include <optional>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"

namespace BRINDLE_EXPORT brindle {

/// How many curves there are and how long, in units of length.
struct CurveLengths {
  std::size_t closed = 0, open = 0;            ///< how many
  double closed_length = 0, open_length = 0;   ///< of all together
  double shortest = 0, mean = 0, longest = 0;  ///< of one curve; 0 if there are none
};

CurveLengths curve_lengths(const Polylines& lines);

/// Distances between neighbouring curves along the surface, measured on both sides of the curves at
/// points about a fifth of 1/f apart, up to 2.5/f; where the next curve is farther (beyond a
/// boundary) nothing is measured.
struct CurveGaps {
  std::size_t measured = 0;                ///< how often; the others are 0 if never
  double least = 0, mean = 0, most = 0;    ///< in units of length
  double least_ratio = 0, mean_ratio = 0;  ///< times f, the frequency asked for there: 1 is ideal
  double most_ratio = 0;
  /// Times the frequency chosen there, which with slack is another one.
  double least_ratio_chosen = 0, mean_ratio_chosen = 0, most_ratio_chosen = 0;
};

/// Distances between neighbouring curves over 1/f of the frequencies chosen, measured on both sides
/// of the curves at points about a fifth of 1/f apart; `wanted` against those that were asked for.
struct CurveSpacing {
  std::size_t measured = 0;            ///< how often a neighbour was there
  double mean = 0;                     ///< of the ratio; 1 is ideal
  double deviation = 0;                ///< standard deviation of the ratio
  double share_within_10_percent = 0;  ///< of what was measured, ratios from 0.9 to 1.1
  double mean_wanted = 0, deviation_wanted = 0, share_within_10_percent_wanted = 0;
  CurveGaps gaps;  ///< measured farther, for makers
};

/// The share of the surface's area, 0 to 1, that is nearer to a curve than half of `width` (units
/// of length), through space: the other side of a sheet thinner than that counts too. Measured at
/// 100,000 places spread evenly over the area: good to about 0.002. 0 for a surface without area.
/// Throws Error if the width is not finite and above zero, and Cancelled if `progress` asks for it.
double curve_coverage(const Mesh& mesh, const Polylines& lines, double width,
                      const Progress& progress = {});

/// Shares of the surface's area that lines of a width cover, 0 to 1.
struct CurveCoverage {
  double once = 0;   ///< by one line or more: `curve_coverage`
  double twice = 0;  ///< of this, by lines on either side, nearer than half of the width both
};

/// Both, measured and refused as `curve_coverage`.
CurveCoverage measure_coverage(const Mesh& mesh, const Polylines& lines, double width,
                               const Progress& progress = {});

/// All of it.
struct CurveMeasures {
  CurveLengths lengths;
  std::optional<CurveGaps> gaps;   ///< not where this would take more than a million points, nor in
                                   ///< a build without nanoflann
  std::optional<double> coverage;  ///< if a width was given
  std::optional<double> covered_twice;  ///< CurveCoverage::twice, if a width was given
};

}  // namespace brindle
