/// Phases that place the first stripe along boundaries.
#pragma once

#include <vector>

#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// One number per vertex: exp(i Phi) at boundary vertices where the wave's direction is within 45
/// degrees of the boundary's normal, 0 elsewhere. The centre of the first stripe lies `periods`
/// inside the boundary. At 0 it would be on the rim; a thousandth of a period keeps it on the
/// surface. At 0.5 the rim is in the middle of a gap. Signs of directions do not matter. Throws
/// Error if `periods` is not finite or if `waves` does not have one entry per vertex.
std::vector<Complex> boundary_phases(const Surface& surface, const WaveSet& waves, float periods);

}  // namespace brindle
