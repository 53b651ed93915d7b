/// Trims ends of curves that are too close to their neighbours.
#pragma once

#include <span>

#include "brindle/curves.h"
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

}  // namespace brindle
