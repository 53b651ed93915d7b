/// Curvatures of a surface in pieces.
#pragma once

#include <vector>

#include "brindle/distributed_surface.h"

namespace brindle {

/// Collective. The greater principal curvature at every vertex of the piece, as
/// `principal_curvatures` has it of the whole; NaN where there is none.
std::vector<float> greatest_curvatures(const DistributedSurface& surface);

}  // namespace brindle
