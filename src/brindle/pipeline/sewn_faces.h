/// Alignment of stripes across creases.
#pragma once

#include <span>

#include "brindle/phase_graph.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// Shifts the phases of every face as a whole, so that stripes align across creases. A face is a
/// part of the surface bounded by creases. Each step increases the sum over links of Re(conj(z_i)
/// z_j), weighted by the waves' alignment. Faces share no edge, so the energy stays. Faces on which
/// the field is not orientable stay. `z` has one phase per vertex.
void sew_faces(const Surface& surface, const WaveSet& waves, std::span<Complex> z);

}  // namespace brindle
