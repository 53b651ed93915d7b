/// Phases that a boundary gives.
#pragma once

#include <vector>

#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// A unit number per vertex, exp(i Phi) in the sense of its wave, for vertices at the boundary
/// whose waves run across it, within 45 degrees; 0 for all others. The centre of the first stripe
/// lies `periods` (of the waves, so many turns of the phase) inside: at 0 on the rim itself, a
/// thousandth of a period inside so that it is on the surface; at 0.5 the rim is in the middle of a
/// gap. Whichever way directions point, it is the same. Throws Error if `periods` is not finite or
/// `waves` has not one entry per vertex.
std::vector<Complex> boundary_phases(const Surface& surface, const WaveSet& waves, float periods);

}  // namespace brindle
