/// Where the stripes of faces lie against each other.
#pragma once

#include <span>

#include "brindle/phase_graph.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// Shifts the stripes of every face, a part of the surface that creases part from all others, as a
/// whole, so that phases meet over creases as well as they can: the sum over links of Re(conj(z_i)
/// z_j), weighted by how much the waves run alike, grows with every step. Links are too weak for
/// sweeps to move whole faces. Nothing within a face changes. Faces on which the field cannot be
/// oriented stay. `z` has a phase for every vertex.
void sew_faces(const Surface& surface, const WaveSet& waves, std::span<Complex> z);

}  // namespace brindle
