/// Waves laid out beside a SlicedLayout, and their coupling without a PhaseGraph in between.
#pragma once

#include <span>
#include <vector>

#include "brindle/phase_shift.h"
#include "brindle/phases/sliced_graph.h"

namespace brindle {

/// One wave by slot. All zero where there is none.
struct alignas(32) SlicedWave {
  float position[3] = {};
  float root_frequency = 0;  ///< sqrt(f)
  float direction[3] = {};
  float unused = 0;
};

/// Copies waves (one entry per node) into the order of slots. Where a direction has turned round
/// against that of the `last` waves (by slot; none if empty; may be those that are overwritten),
/// the phase in `z` and the momentum in `m` (by slot; may be empty) are turned with it, so that
/// they still mean the same wave. Returns whether anything differs from the last waves.
bool load_waves(const SlicedLayout& layout, std::span<const Vec3> positions,
                std::span<const Vec3> directions, std::span<const float> frequencies,
                std::vector<SlicedWave>& waves, std::span<const SlicedWave> last = {},
                std::span<Complex> z = {}, std::span<Complex> m = {});

/// Turns the phases or momenta in `z` (by slot; may be empty) where directions have turned round
/// from one list of waves to the other. The same again undoes it to the bit.
void turn_phases(std::span<const SlicedWave> from, std::span<const SlicedWave> to,
                 std::span<Complex> z);

/// Edge weights by entry, from weights by directed edge of the adjacency that the layout was made
/// of.
std::vector<float> sliced_weights(const SlicedLayout& layout, const Adjacency& adjacency,
                                  std::span<const float> edge_weights);

/// All couplings at once, as build_phase_graph and load_couplings would give them.
/// `entry_weights` is empty or has one weight per entry. `degree` receives the sum of weights of
/// every slot's row. `kind` is aligned or trapezoid: the paper's common source goes through a
/// PhaseGraph; throws Error.
void couple(const SlicedLayout& layout, std::span<const SlicedWave> waves, PhaseShiftKind kind,
            std::span<const float> entry_weights, SlicedCouplings& couplings,
            std::span<float> degree);

}  // namespace brindle
