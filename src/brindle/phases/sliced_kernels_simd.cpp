
#include "brindle/phases/sliced_kernels.h"
#include "brindle/phases/sliced_waves.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brindle/phases/sliced_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brindle::simd::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, kLanes>;
using U = hn::RebindToUnsigned<D>;
using S = hn::RebindToSigned<D>;

// Products are rounded before they are added, as on processors without fused multiply-adds.
using Real = hn::Vec<D>;
using Truth = hn::Mask<D>;
using Bits = hn::Vec<U>;
constexpr auto kReals = static_cast<Index>(hn::MaxLanes(D()));

HWY_INLINE Real real(float value) { return hn::Set(D(), value); }
HWY_INLINE Real zero() { return hn::Zero(D()); }
HWY_INLINE Real load(const float* from) { return hn::Load(D(), from); }
HWY_INLINE Real load_unaligned(const float* from) { return hn::LoadU(D(), from); }
HWY_INLINE void store(Real value, float* to) { hn::Store(value, D(), to); }
HWY_INLINE void store_unaligned(Real value, float* to) { hn::StoreU(value, D(), to); }
HWY_INLINE Real negative(Real a) { return hn::Neg(a); }
HWY_INLINE Real absolute(Real a) { return hn::Abs(a); }
HWY_INLINE Real square_root(Real a) { return hn::Sqrt(a); }
HWY_INLINE Real nearest(Real a) { return hn::Round(a); }

HWY_INLINE Truth less(Real a, Real b) { return hn::Lt(a, b); }
HWY_INLINE Real chosen(Truth truth, Real yes, Real no) { return hn::IfThenElse(truth, yes, no); }
HWY_INLINE Real zero_where(Truth truth, Real a) { return hn::IfThenZeroElse(truth, a); }
HWY_INLINE Real zero_unless(Truth truth, Real a) { return hn::IfThenElseZero(truth, a); }
HWY_INLINE Truth both(Truth a, Truth b) { return hn::And(a, b); }
HWY_INLINE bool any(Truth a) { return !hn::AllFalse(D(), a); }
template <class Body>
HWY_INLINE void for_each(Truth truth, const Body& body) {
  std::uint8_t mask[8] = {};
  hn::StoreMaskBits(D(), truth, mask);
  for (Index lane = 0; lane < kReals; ++lane) {
    if (((mask[lane / 8] >> (lane % 8)) & 1) != 0) body(lane);
  }
}

HWY_INLINE Bits bits(std::uint32_t value) { return hn::Set(U(), value); }
HWY_INLINE Bits ascending_bits(Index first) { return hn::Iota(U(), first); }
HWY_INLINE Bits load_bits(const Index* from) { return hn::LoadU(U(), from); }
HWY_INLINE void store_bits(Bits a, Index* to) { hn::Store(a, U(), to); }
HWY_INLINE Bits bits_of(Real a) { return hn::BitCast(U(), a); }
HWY_INLINE Real real_of(Bits a) { return hn::BitCast(D(), a); }
HWY_INLINE Truth equal(Bits a, Bits b) { return hn::RebindMask(D(), hn::Eq(a, b)); }
HWY_INLINE Bits without(Bits a, Bits mask) { return hn::AndNot(mask, a); }
HWY_INLINE Bits times_four(Bits a) { return hn::ShiftLeft<2>(a); }
HWY_INLINE Bits to_sign(Bits a) { return hn::ShiftLeft<31>(a); }
HWY_INLINE Bits sign_if_odd(Real whole) {
  return to_sign(hn::BitCast(U(), hn::ConvertTo(S(), whole)));
}

struct Numbers {
  Real re;
  Real im;
};
HWY_INLINE Numbers load_complex(const Complex* from) {
  hn::Vec<D> re, im;
  hn::LoadInterleaved2(D(), reinterpret_cast<const float*>(from), re, im);
  return {re, im};
}
HWY_INLINE void store_complex(const Numbers& z, Complex* to) {
  hn::StoreInterleaved2(z.re, z.im, D(), reinterpret_cast<float*>(to));
}

#if HWY_TARGET == HWY_SCALAR || HWY_HAVE_SCALABLE
HWY_INLINE Numbers gathered(const Complex* from, const Index* index) {
  const auto twice = hn::ShiftLeft<1>(hn::BitCast(S(), hn::LoadU(U(), index)));
  const auto* parts = reinterpret_cast<const float*>(from);
  return {hn::GatherIndex(D(), parts, twice), hn::GatherIndex(D(), parts + 1, twice)};
}
#else
/// Loads pairs of floats one by one as 64-bit numbers. Gather instructions are slower on most
/// processors, and far slower on those that mitigate CVE-2022-40982.
template <class P>
HWY_INLINE hn::Vec<P> gather_pairs(P pairs, const std::uint64_t* z, const Index* index) {
  if constexpr (hn::MaxLanes(P()) == 1) {
    return hn::Load(pairs, z + *index);
  } else {
    const hn::Half<P> half;
    constexpr std::size_t kHalf = hn::MaxLanes(P()) / 2;
    return hn::Combine(pairs, gather_pairs(half, z, index + kHalf), gather_pairs(half, z, index));
  }
}

HWY_INLINE Numbers gathered(const Complex* from, const Index* index) {
  const hn::Repartition<std::uint64_t, D> wide;
  const auto* pairs = reinterpret_cast<const std::uint64_t*>(from);
  const auto first = hn::BitCast(D(), gather_pairs(wide, pairs, index));
  const auto second = hn::BitCast(D(), gather_pairs(wide, pairs, index + kReals / 2));
  return {hn::ConcatEven(D(), second, first), hn::ConcatOdd(D(), second, first)};
}
#endif

HWY_INLINE Numbers gathered_couplings(const float* direct, const Index* entries) {
  const auto stored = hn::LoadU(U(), entries);
  const auto entry = hn::IfThenZeroElse(hn::Eq(stored, hn::Set(U(), kNone)), stored);
  const auto lane = hn::And(entry, hn::Set(U(), kLanes - 1));
  const auto at = hn::BitCast(S(), hn::Add(hn::ShiftLeft<1>(hn::Sub(entry, lane)), lane));
  return {hn::GatherIndex(D(), direct, at),
          hn::GatherIndex(D(), direct, hn::Add(at, hn::Set(S(), kLanes)))};
}

}  // namespace

#undef BRINDLE_KERNEL
#define BRINDLE_KERNEL HWY_INLINE
#include "brindle/phases/sliced_kernels_body.h"

const char* target_name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace brindle::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brindle::simd {

HWY_EXPORT(couple_slices);
HWY_EXPORT(sweep_slices);
HWY_EXPORT(relax_slices);
HWY_EXPORT(gauge_slices);
HWY_EXPORT(gauge_members);
HWY_EXPORT(sum_slices);
HWY_EXPORT(sum_marked_slice);
HWY_EXPORT(prolong_slices);
HWY_EXPORT(target_name);

void couple_slices(const SlicedLayout& layout, const SlicedWave* waves, PhaseShiftKind kind,
                   const float* entry_weights, SlicedCouplings& couplings, float* degree,
                   SliceRange range) {
  HWY_DYNAMIC_DISPATCH(couple_slices)(layout, waves, kind, entry_weights, couplings, degree, range);
}

void sweep_slices(const SlicedLayout& layout, const SlicedCouplings& couplings, Complex* z,
                  float over_relaxation, SliceRange range) {
  HWY_DYNAMIC_DISPATCH(sweep_slices)(layout, couplings, z, over_relaxation, range);
}

double relax_slices(const SlicedLayout& layout, const SlicedCouplings& couplings, Complex* z,
                    float strength, Complex* momentum, SliceRange range) {
  return HWY_DYNAMIC_DISPATCH(relax_slices)(layout, couplings, z, strength, momentum, range);
}

void gauge_slices(const SlicedLayout& layout, const SlicedCouplings& couplings,
                  const Complex* gauge, Complex* gauged, SliceRange range) {
  HWY_DYNAMIC_DISPATCH(gauge_slices)(layout, couplings, gauge, gauged, range);
}

void gauge_members(const SlicedCouplings& couplings, const GaugeSchedule& rounds, Complex* gauge,
                   SliceRange groups) {
  HWY_DYNAMIC_DISPATCH(gauge_members)(couplings, rounds, gauge, groups);
}

void sum_slices(const SlicedLayout& coarse, const Index* round_begin, const Index* round_entry,
                const Complex* gauged, float* direct, std::uint8_t* marked, SliceRange range) {
  HWY_DYNAMIC_DISPATCH(sum_slices)(coarse, round_begin, round_entry, gauged, direct, marked, range);
}

void sum_marked_slice(const SlicedLayout& coarse, const Index* round_begin,
                      const Index* round_entry, const Complex* gauged, Complex* reflecting,
                      Index slice) {
  HWY_DYNAMIC_DISPATCH(sum_marked_slice)
  (coarse, round_begin, round_entry, gauged, reflecting, slice);
}

void prolong_slices(const Complex* gauge, const Index* coarse_slot, const Complex* coarse,
                    Complex* z, SliceRange range) {
  HWY_DYNAMIC_DISPATCH(prolong_slices)(gauge, coarse_slot, coarse, z, range);
}

const char* target_name() { return HWY_DYNAMIC_DISPATCH(target_name)(); }

}  // namespace brindle::simd
#endif  // HWY_ONCE
