/// Trims ends of curves that are too close to their neighbours.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brindle/curves.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"

namespace brindle {

/// Cuts each curve end in a branch or singularity back to the first place that has enough room and
/// is straight. Enough room: no curve beside it or across its path is nearer than `least_gap`
/// (above 0, at most 1) times 1/f along the surface. Straight: the direction is that of one period
/// before, within 26 degrees; this is given up after two periods. Cut curves shorter than 1/f are
/// removed. `frequencies` has one entry per point of the lines, above zero. Ends at boundaries and
/// holes stay, as do reasons of ends. Neighbours are the uncut curves, so the result does not
/// depend on the direction and order of curves. Throws Error for a gap out of range and for another
/// number of frequencies; Cancelled if `progress` cancels.
StripeCurves trimmed_ends(const StripeCurves& curves, std::span<const float> frequencies,
                          float least_gap, const Progress& progress = {});

// Paths over the surface from the end of a curve to the curve beside it.

/// Extends curves that end alone in a branch or singularity.
class EndWalks {
 public:
  /// `waves` must outlive it.
  explicit EndWalks(const LiftedWaves& waves);

  /// The path from the inner end of `piece`, one of the joined `pieces` of triangle `t`, to the
  /// curve beside it: points on the crossed edges, and finally on the curve. Empty if the end
  /// already lies on another piece. The path is the shorter of two straight ones, at 45 degrees
  /// forward to either side; nullopt if neither meets a curve within two periods.
  std::optional<std::vector<TrianglePoint>> way_on(std::size_t t, const StripePiece& piece,
                                                   std::span<const StripePiece> pieces) const;

 private:
  struct Walker;
  struct Step;

  Step next_step(const Walker& walker) const;
  bool cross_edge(Walker& walker, int edge) const;
  void walk(Walker& walker) const;

  const LiftedWaves& waves_;
};

}  // namespace brindle
