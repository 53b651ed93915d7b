/// Curves that rank 0 makes of the whole surface.
#pragma once

#include "brindle/distributed/curves/rank_pattern.h"
#include "brindle/distributed/surface/whole_on_first.h"
#include "brindle/distributed_pattern.h"

namespace brindle {

/// Collective. What owners have at vertices, on rank 0 in the order of the whole. Throws what
/// `check_pattern` does.
RankWaves whole_waves(const WholeOnFirst& whole, const PiecePattern& pattern);

/// As `whole_curves` of a surface that rank 0 has already.
WholeCurves whole_curves(const WholeOnFirst& whole, const PiecePattern& pattern,
                         const CurveOptions& options, const Progress& progress = {});

}  // namespace brindle
