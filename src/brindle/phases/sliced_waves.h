/// Waves in the order of a SlicedLayout, and their couplings without an intermediate PhaseGraph.
#pragma once

#include <span>
#include <vector>

#include "brindle/phase_shift.h"
#include "brindle/phases/sliced_graph.h"

namespace brindle {

/// The wave of a slot, all zero for padding.
struct alignas(32) SlicedWave {
  float position[3] = {};
  float root_frequency = 0;  ///< sqrt(f)
  float direction[3] = {};
  float unused = 0;
};

/// Copies waves (one entry per node) into slot order. `last` are the previous waves, by slot
/// (empty: none; may be those that are overwritten). Where a direction is reversed against them,
/// the phase in `z` and the momentum in `m` (by slot; may be empty) become -conj(z) and -conj(m),
/// which describe the same wave. Returns whether anything differs from the last waves.
bool load_waves(const SlicedLayout& layout, std::span<const Vec3> positions,
                std::span<const Vec3> directions, std::span<const float> frequencies,
                std::vector<SlicedWave>& waves, std::span<const SlicedWave> last = {},
                std::span<Complex> z = {}, std::span<Complex> m = {});

/// Replaces phases or momenta z (by slot; may be empty) by -conj(z) where directions are reversed
/// between the two lists of waves. A second call restores all bits.
void turn_phases(std::span<const SlicedWave> from, std::span<const SlicedWave> to,
                 std::span<Complex> z);

/// Edge weights by entry, from weights by directed edge of the layout's adjacency.
std::vector<float> sliced_weights(const SlicedLayout& layout, const Adjacency& adjacency,
                                  std::span<const float> edge_weights);

/// Computes the couplings of `build_phase_graph` and `load_couplings`, up to rounding.
/// `entry_weights` is empty or has one weight per entry. `degree` receives the sum of weights of
/// each slot's row. `kind` is aligned or trapezoid; throws Error for the paper's common source,
/// which needs a PhaseGraph.
void couple(const SlicedLayout& layout, std::span<const SlicedWave> waves, PhaseShiftKind kind,
            std::span<const float> entry_weights, SlicedCouplings& couplings,
            std::span<float> degree);

/// The same for waves by node, with `edge_weights` as in `build_phase_graph`. Also
/// throws Error for inputs that `build_phase_graph` rejects.
void couple_waves(const SlicedLayout& layout, const Adjacency& adjacency, const WaveSet& waves,
                  PhaseShiftKind kind, std::span<const float> edge_weights,
                  SlicedCouplings& couplings);

}  // namespace brindle
