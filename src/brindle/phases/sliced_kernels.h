/// The inner loops of the solvers over slices of a SlicedLayout. They are written once
/// (sliced_kernels_body.h) and compiled twice: as portable C++, and for Highway vectors, whose
/// instruction set is chosen at run time. Neither uses fused multiply-adds, so results have the
/// same bits on every processor.
#pragma once

#include <algorithm>
#include <cstdint>

#include "brindle/base/standard.h"
#include "brindle/phase_shift.h"
#include "brindle/phases/aggregation.h"
#include "brindle/phases/sliced_graph.h"
#include "brindle/types.h"

namespace brindle {

/// A gauge or coupling whose real part stores in its lowest bit whether it applies to the
/// conjugate. The relative error is 1e-7, and one gather loads both.
constexpr Complex with_conjugate_bit(Complex value, bool conjugate) {
  const auto bits = bit_cast<std::uint32_t>(value.real());
  return {bit_cast<float>((bits & ~1u) | static_cast<std::uint32_t>(conjugate)), value.imag()};
}
constexpr bool conjugate_bit(Complex value) {
  return (bit_cast<std::uint32_t>(value.real()) & 1u) != 0;
}

struct SlicedWave;

/// The sum over lanes by halving, an order that does not depend on the vector length.
inline float sum_of_lanes(const float* numbers) {
  float sum[kLanes];
  std::copy_n(numbers, kLanes, sum);
  for (Index half = kLanes / 2; half > 0; half /= 2) {
    for (Index lane = 0; lane < half; ++lane) sum[lane] += sum[lane + half];
  }
  return sum[0];
}

/// The couplings of all entries of a range, and the sums of their weights by slot; see `couple` in
/// sliced_waves.h. `entry_weights` may be null.
using CoupleSlices = void(const SlicedLayout&, const SlicedWave* waves, PhaseShiftKind kind,
                          const float* entry_weights, SlicedCouplings&, float* degree, SliceRange);

/// z_i = t_i / |t_i| (Eq. 10 without momentum) for all rows, or over-relaxed (`sweep` of
/// sliced_graph.h); rows without a target keep their phase. All rows of a range must have one
/// colour.
using SweepSlices = void(const SlicedLayout&, const SlicedCouplings&, Complex* z,
                         float over_relaxation, SliceRange);

/// Eq. 10 and 11 for all rows; returns the decrease of the energy.
using RelaxSlices = double(const SlicedLayout&, const SlicedCouplings&, Complex* z, float strength,
                           Complex* momentum, SliceRange);

/// The direct couplings of all entries of a range between the unknowns of the coarser level:
/// conj(g_i) A g_j, conjugated if z_i = g_i conj(Z). `gauged` receives them in order, from the
/// range's first. Results with the conjugate bit add to B of the coarser level, others to A.
using GaugeSlices = void(const SlicedLayout&, const SlicedCouplings&, const Complex* gauge,
                         Complex* gauged, SliceRange);

/// Gauges of groups of one rank from the direct couplings to earlier members. S = sum A g over
/// members without the conjugate bit, C over members with it. The gauge is the longer of the two,
/// normalised, with the conjugate bit if it is C; 1 if both are 0.
using GaugeMembers = void(const SlicedCouplings&, const GaugeSchedule&, Complex* gauge,
                          SliceRange groups);

/// Direct couplings of the coarse slices of a range: sums over rounds of gauged entries without the
/// conjugate bit. `marked` becomes 1 for slices that have entries with the bit.
using SumSlices = void(const SlicedLayout& coarse, const Index* round_begin,
                       const Index* round_entry, const Complex* gauged, float* direct,
                       std::uint8_t* marked, SliceRange);

/// Reflecting couplings of all entries of one coarse slice: sums over rounds of gauged entries with
/// the conjugate bit. `reflecting` receives them entry by entry.
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

/// The active instruction set, such as "AVX3" or "NEON".
const char* target_name();
}  // namespace simd
namespace kernels = simd;
#else
namespace kernels = portable;
#endif

}  // namespace brindle
