/// The inner loops of the solvers over slices of a SlicedLayout, twice: portable C++, and Highway
/// vectors with the instruction set chosen at run time. Both follow the same order of operations,
/// without fused multiply-adds, and so give the same bits on every processor.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "brindle/base/standard.h"
#include "brindle/phase_shift.h"
#include "brindle/phases/gauge_rounds.h"
#include "brindle/phases/sliced_graph.h"
#include "brindle/types.h"

namespace brindle {

/// A gauge or a coupling that says in the lowest bit of its real part, a relative error of 1e-7,
/// whether it goes with the conjugate. One gather then brings both.
constexpr Complex with_conjugate_bit(Complex value, bool conjugate) {
  const auto bits = bit_cast<std::uint32_t>(value.real());
  return {bit_cast<float>((bits & ~1u) | static_cast<std::uint32_t>(conjugate)), value.imag()};
}
constexpr bool conjugate_bit(Complex value) {
  return (bit_cast<std::uint32_t>(value.real()) & 1u) != 0;
}

struct SlicedWave;

/// The sum of one number a lane, by halves: an order that does not depend on how long vectors are.
inline float sum_of_lanes(const float* numbers) {
  float sum[kLanes];
  std::copy_n(numbers, kLanes, sum);
  for (Index half = kLanes / 2; half > 0; half /= 2) {
    for (Index lane = 0; lane < half; ++lane) sum[lane] += sum[lane + half];
  }
  return sum[0];
}

/// The couplings of all entries of a range and the sums of their weights by slot; see `couple` in
/// sliced_waves.h. `entry_weights` may be null.
using CoupleSlices = void(const SlicedLayout&, const SlicedWave* waves, PhaseShiftKind kind,
                          const float* entry_weights, SlicedCouplings&, float* degree, SliceRange);

/// z_i = t_i / |t_i| for all rows, or beyond that by over-relaxation (`sweep` of sliced_graph.h);
/// rows without a target keep their phase. The rows of a range must have one colour.
using SweepSlices = void(const SlicedLayout&, const SlicedCouplings&, Complex* z,
                         float over_relaxation, SliceRange);

/// Eq. 10 and 11 for all rows; returns by how much it lowers the energy.
using RelaxSlices = double(const SlicedLayout&, const SlicedCouplings&, Complex* z, float strength,
                           Complex* momentum, SliceRange);

/// Turns the direct couplings of all entries of a range into the gauges at their ends:
/// conj(g_i) A g_j, conjugated if z_i = g_i conj(Z); entry by entry into `gauged`, from the
/// first of the range on. The conjugate bit of a result says that it adds to B of the coarser
/// level, not to A.
using GaugeSlices = void(const SlicedLayout&, const SlicedCouplings&, const Complex* gauge,
                         Complex* gauged, SliceRange);

/// Gauges of groups of one rank from the direct couplings to earlier
/// members: with S = sum A g over members without and C over members with the conjugate bit, the
/// longer of the two over its length, its own conjugate bit set if that is C. Without either, 1.
using GaugeMembers = void(const SlicedCouplings&, const GaugeRounds&, Complex* gauge,
                          SliceRange groups);

/// Direct couplings of the coarse slices of a range: sums of the gauged entries without conjugate
/// bit that the rounds name. `marked` tells for every slice whether there are others.
using SumSlices = void(const SlicedLayout& coarse, const Index* round_begin,
                       const Index* round_entry, const Complex* gauged, float* direct,
                       std::uint8_t* marked, SliceRange);

/// Reflecting couplings of all entries of one coarse slice: sums of the gauged entries with
/// conjugate bit that the rounds name, entry by entry into `reflecting`.
using SumMarkedSlice = void(const SlicedLayout& coarse, const Index* round_begin,
                            const Index* round_entry, const Complex* gauged, Complex* reflecting,
                            Index slice);

/// z_i = g_i Z or g_i conj(Z) with Z = coarse[coarse_slot[i]], for all slots of a range.
using ProlongSlices = void(const Complex* gauge, const Index* coarse_slot, const Complex* coarse,
                           Complex* z, SliceRange);

namespace portable {
CoupleSlices couple_slices;
SweepSlices sweep_slices;
RelaxSlices relax_slices;
GaugeSlices gauge_slices;
GaugeMembers gauge_members;
SumSlices sum_slices;
SumMarkedSlice sum_marked_slice;
ProlongSlices prolong_slices;
}  // namespace portable

#ifdef BRINDLE_HAS_HIGHWAY
namespace simd {
CoupleSlices couple_slices;
SweepSlices sweep_slices;
RelaxSlices relax_slices;
GaugeSlices gauge_slices;
GaugeMembers gauge_members;
SumSlices sum_slices;
SumMarkedSlice sum_marked_slice;
ProlongSlices prolong_slices;

/// The instruction set in use, such as "AVX3" or "NEON".
const char* target_name();
}  // namespace simd
namespace kernels = simd;
#else
namespace kernels = portable;
#endif

}  // namespace brindle
