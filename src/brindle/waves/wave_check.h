/// Values that no wave can have, refused before they spoil a pattern.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/adjacency.h"
#include "brindle/phase_graph.h"
#include "brindle/types.h"

namespace brindle {

/// Throws Error unless every position is finite, every direction a unit vector (to half a percent)
/// or zero, and every frequency finite and above zero, also where there is no wave. The message
/// names the first vertex that is not so, what is wrong with it and the remedy. All spans have one
/// entry per vertex.
void check_waves(std::span<const Vec3> positions, std::span<const Vec3> directions,
                 std::span<const float> frequencies);

/// Throws Error unless there is one phase for each of `count` vertices, a number of length 1 (to
/// half a percent) or 0, naming the first that is neither.
void check_last_phases(std::span<const Complex> z, std::size_t count);

/// Throws Error unless each of the edge weights is finite and not negative, naming the first that
/// is not.
void check_edge_weights(std::span<const float> weights);

/// Throws Error unless `waves` has one entry per node and `edge_weights` one per directed edge, or
/// none, and for what `check_waves` and `check_edge_weights` refuse.
void check_coupled_waves(const Adjacency& adjacency, const WaveSet& waves,
                         std::span<const float> edge_weights);

}  // namespace brindle
