/// Stripes of a surface in pieces, moved along their waves.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/distributed_surface.h"
#include "brindle/phase_graph.h"

namespace brindle {

/// Collective. What `shift_phases` does with the whole, at the vertices of the piece. Where
/// directions can run alike they do so over all ranks, and the bits are those of one process; where
/// they cannot, moved curves may jog elsewhere.
std::size_t shift_phases(const DistributedSurface& surface, float periods, WaveSet& waves,
                         std::span<Complex> z);

}  // namespace brindle
