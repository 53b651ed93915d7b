/// Curves that run on into their neighbours over the borders of pieces.
#pragma once

#include <span>

#include "brindle/distributed/curves/rank_pattern.h"
#include "brindle/pattern/lifted_waves.h"

namespace brindle {

/// Must be called by all ranks. Lets the curves go whose walks are `beyond`: to the neighbour that
/// they meet first. The parts of their ways on other ranks become curves there, which begin with
/// the crossing at which the part before has ended.
void continue_ends(const RankSurface& surface, const RankTriangles& triangles,
                   const LiftedWaves& waves, std::span<const EdgeBeyond> beyond, CutCurves& curves);

}  // namespace brindle
