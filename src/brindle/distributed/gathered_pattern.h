/// Curves and samples that rank 0 computes on the whole surface.
#pragma once

#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed_pattern.h"
#include "brindle/stripe_pattern.h"

namespace brindle {

// All of these are collective.

/// Waves and phases of all vertices, on rank 0. Throws Error on all ranks for patterns that do not
/// match their partition.
StripePattern gathered_pattern(const GatheredSurface& whole, const PiecePattern& pattern);

/// Rank 0's curves on the whole surface, cut at borders. Their points lie on edges.
PieceCurves cut_curves(const GatheredSurface& whole, const StripeCurves& curves);

}  // namespace brindle
