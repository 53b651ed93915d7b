/// Phases at boundaries.
#pragma once

#include <vector>

#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// One number per vertex: exp(i Phi) for boundary vertices whose waves run across the boundary,
/// within 45 degrees; 0 for all others. The centre of the first stripe lies `periods` of the waves
/// inside. At 0 it is on the rim, a thousandth of a period inside so that it is on the surface; at
/// 0.5 the rim is in the middle of a gap. Signs of directions do not matter. Throws Error if
/// `periods` is not finite or if `waves` does not have one entry per vertex.
std::vector<Complex> boundary_phases(const Surface& surface, const WaveSet& waves, float periods);

}  // namespace brindle
