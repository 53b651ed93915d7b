/// Ends of curves that are cut back where neighbours leave them too little room.
#pragma once

#include <span>

#include "brindle/curves.h"
#include "brindle/progress.h"

namespace brindle {

/// Cuts curves that end in a branch or singularity back, each end for itself, to the first place
/// where no curve beside it or across its way is nearer than `least_gap` (0 to 1) of 1/f along the
/// surface, and where it runs the way it ran one period before, within 26 degrees. The latter is
/// given up after two periods. What is left of a curve and shorter than 1/f goes. `frequencies` has
/// one entry per point of the lines, above zero. Boundaries and holes keep their ends, and reasons
/// of ends stay as they are. Neighbours are those that were there before: the result is the same
/// whichever way and in which order curves run.
/// Throws Error for a gap out of range and for another number of frequencies, and Cancelled if
/// `progress` asks for it.
StripeCurves trimmed_ends(const StripeCurves& curves, std::span<const float> frequencies,
                          float least_gap, const Progress& progress = {});

}  // namespace brindle
