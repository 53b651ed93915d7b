#include <algorithm>
#include <limits>

#include "brindle/phases/sliced_kernels.h"
#include "brindle/phases/sliced_waves.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brindle/phases/sliced_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brindle::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, kLanes>;
using U = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using Indices = hn::Vec<U>;

/// Complex numbers, one a lane.
struct Z {
  V re;
  V im;
};

HWY_INLINE Index lanes() { return static_cast<Index>(hn::Lanes(D())); }

#if HWY_TARGET == HWY_SCALAR || HWY_HAVE_SCALABLE
HWY_INLINE Z gather(const Complex* z, const Index* index) {
  const D d;
  const hn::RebindToSigned<D> offset;
  const auto twice = hn::ShiftLeft<1>(hn::BitCast(offset, hn::LoadU(U(), index)));
  const auto* parts = reinterpret_cast<const float*>(z);
  return {hn::GatherIndex(d, parts, twice), hn::GatherIndex(d, parts + 1, twice)};
}
#else
/// Pairs of floats, as 64-bit numbers, loaded one by one: gather instructions are slower on most
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

HWY_INLINE Z gather(const Complex* z, const Index* index) {
  const hn::Repartition<std::uint64_t, D> wide;
  const auto* pairs = reinterpret_cast<const std::uint64_t*>(z);
  const V first = hn::BitCast(D(), gather_pairs(wide, pairs, index));
  const V second = hn::BitCast(D(), gather_pairs(wide, pairs, index + hn::MaxLanes(D()) / 2));
  return {hn::ConcatEven(D(), second, first), hn::ConcatOdd(D(), second, first)};
}
#endif

HWY_INLINE Z load(const Complex* z) {
  Z result;
  hn::LoadInterleaved2(D(), reinterpret_cast<const float*>(z), result.re, result.im);
  return result;
}

HWY_INLINE void store(Z value, Complex* z) {
  hn::StoreInterleaved2(value.re, value.im, D(), reinterpret_cast<float*>(z));
}

/// Real and imaginary parts of a part of a column of couplings.
HWY_INLINE Z load_column(const float* column) {
  return {hn::LoadU(D(), column), hn::LoadU(D(), column + kLanes)};
}

/// a b + c, rounded twice: processors without fused multiply-adds could not follow.
HWY_INLINE V multiply_add(V a, V b, V c) { return hn::Add(hn::Mul(a, b), c); }

HWY_INLINE Z product(Z a, Z b) {
  return {hn::Sub(hn::Mul(a.re, b.re), hn::Mul(a.im, b.im)),
          hn::Add(hn::Mul(a.re, b.im), hn::Mul(a.im, b.re))};
}

/// conj(a) b.
HWY_INLINE Z conjugate_product(Z a, Z b) {
  return {hn::Add(hn::Mul(a.re, b.re), hn::Mul(a.im, b.im)),
          hn::Sub(hn::Mul(a.re, b.im), hn::Mul(a.im, b.re))};
}

/// exp(2 pi i turns): Taylor series about the nearest half turn, errors below 3e-7.
HWY_INLINE Z unit(V turns) {
  const D d;
  const V rest = hn::Sub(turns, hn::Round(turns));
  const V half_turns = hn::Round(hn::Add(rest, rest));
  const V x =
      hn::Mul(hn::Sub(rest, hn::Mul(half_turns, hn::Set(d, 0.5f))), hn::Set(d, 6.283185307f));
  const V x2 = hn::Mul(x, x);
  V sine = hn::Set(d, -2.505210839e-8f);
  for (const float c : {2.755731922e-6f, -1.984126984e-4f, 8.333333333e-3f, -0.1666666667f, 1.0f}) {
    sine = multiply_add(sine, x2, hn::Set(d, c));
  }
  V cosine = hn::Set(d, 2.087675699e-9f);
  for (const float c :
       {-2.755731922e-7f, 2.480158730e-5f, -1.388888889e-3f, 4.166666667e-2f, -0.5f, 1.0f}) {
    cosine = multiply_add(cosine, x2, hn::Set(d, c));
  }
  // An odd number of half turns changes both signs.
  const hn::RebindToSigned<D> whole;
  const auto sign = hn::BitCast(d, hn::ShiftLeft<31>(hn::ConvertTo(whole, half_turns)));
  return {hn::Xor(cosine, sign), hn::Xor(hn::Mul(sine, x), sign)};
}

/// Waves, one a lane.
struct Waves {
  V x, y, z, root_frequency, dx, dy, dz;
};

HWY_INLINE Waves gather_waves(const SlicedWave* waves, const Index* slot) {
  // A wave is four pairs of floats.
  const auto* pairs = reinterpret_cast<const Complex*>(waves);
  alignas(64) Index first[kLanes];
  hn::Store(hn::ShiftLeft<2>(hn::LoadU(U(), slot)), U(), first);
  const Z xy = gather(pairs, first), zf = gather(pairs + 1, first);
  const Z d = gather(pairs + 2, first), d3 = gather(pairs + 3, first);
  return {xy.re, xy.im, zf.re, zf.im, d.re, d.im, d3.re};
}

HWY_INLINE Waves load_waves(const SlicedWave* waves) {
  alignas(64) Index slot[kLanes];
  hn::Store(hn::Iota(U(), 0), U(), slot);
  return gather_waves(waves, slot);
}

/// What couple_slices does to Lanes entries; returns their weights.
HWY_INLINE V couple_entries(const SlicedLayout& layout, const Waves& i, const SlicedWave* waves,
                            bool trapezoid, const float* entry_weights, Index slice,
                            std::size_t entry, SlicedCouplings& couplings) {
  const D d;
  const U bits;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const Indices slot_j = hn::LoadU(bits, layout.neighbor.data() + entry);
  const auto own = static_cast<Index>(slice * kLanes + entry % kLanes);
  const auto filling = hn::RebindMask(d, hn::Eq(slot_j, hn::Iota(bits, own)));
  const Waves j = gather_waves(waves, layout.neighbor.data() + entry);
  const V ex = hn::Sub(i.x, j.x), ey = hn::Sub(i.y, j.y), ez = hn::Sub(i.z, j.z);
  const auto dot = [](V ax, V ay, V az, V bx, V by, V bz) {
    return multiply_add(ax, bx, multiply_add(ay, by, hn::Mul(az, bz)));
  };
  const V cosine = dot(i.dx, i.dy, i.dz, j.dx, j.dy, j.dz);
  const V along_j = dot(ex, ey, ez, j.dx, j.dy, j.dz);
  const V along_i = dot(ex, ey, ez, i.dx, i.dy, i.dz);
  const auto reflects = hn::Lt(cosine, zero);
  const V along = hn::Add(along_j, hn::IfThenElse(reflects, hn::Neg(along_i), along_i));
  const V distance = hn::Div(along, trapezoid ? hn::Set(d, 2.0f) : hn::Add(one, hn::Abs(cosine)));
  const V turns = hn::Mul(hn::Mul(i.root_frequency, j.root_frequency), distance);
  V weight = hn::IfThenZeroElse(filling, hn::Abs(cosine));
  if (entry_weights) weight = hn::Mul(weight, hn::LoadU(d, entry_weights + entry));
  const Z e = unit(turns);
  const V re = hn::Mul(weight, e.re), im = hn::Mul(weight, e.im);
  float* const column = couplings.direct.get() + SlicedCouplings::real_part(entry);
  hn::StoreU(hn::IfThenZeroElse(reflects, re), d, column);
  hn::StoreU(hn::IfThenZeroElse(reflects, im), d, column + kLanes);
  if (hn::AllFalse(d, reflects)) return weight;
  alignas(64) float b_re[kLanes], b_im[kLanes];
  hn::Store(hn::Neg(re), d, b_re);
  hn::Store(im, d, b_im);
  std::uint8_t reflects_bits[8] = {};
  hn::StoreMaskBits(d, reflects, reflects_bits);
  for (Index lane = 0; lane < lanes(); ++lane) {
    if (((reflects_bits[lane / 8] >> (lane % 8)) & 1) == 0) continue;
    couplings.append_reflecting(
        layout, slice, {static_cast<Index>(entry + lane), Complex(b_re[lane], b_im[lane])});
  }
  return weight;
}

void couple_slices(const SlicedLayout& layout, const SlicedWave* waves, PhaseShiftKind kind,
                   const float* entry_weights, SlicedCouplings& couplings, float* degree,
                   SliceRange range) {
  const D d;
  for (Index slice = range.begin; slice < range.end; ++slice) {
    couplings.reflecting_count[slice] = 0;
    float* const sum = degree + slice * kLanes;
    std::fill_n(sum, kLanes, 0.0f);
    for (std::size_t column = layout.column_begin[slice]; column < layout.column_begin[slice + 1];
         ++column) {
      for (Index lane = 0; lane < kLanes; lane += lanes()) {
        const Waves i = load_waves(waves + slice * kLanes + lane);
        const V weight = couple_entries(layout, i, waves, kind == PhaseShiftKind::trapezoid,
                                        entry_weights, slice, column * kLanes + lane, couplings);
        hn::StoreU(hn::Add(hn::LoadU(d, sum + lane), weight), d, sum + lane);
      }
    }
  }
}

/// Adds B conj(z_j) of a slice to the targets of its rows lane .. lane + Lanes - 1.
HWY_NOINLINE void add_reflecting(const SlicedLayout& layout, const SlicedCouplings& couplings,
                                 const Complex* z, Index slice, Index lane, Z& t) {
  alignas(64) float re[kLanes], im[kLanes];
  hn::Store(t.re, D(), re);
  hn::Store(t.im, D(), im);
  for (const auto& [entry, b] : couplings.reflecting_of(layout, slice)) {
    const Index row = entry % kLanes - lane;
    if (row >= lanes()) continue;
    const Complex added = b * std::conj(z[layout.neighbor[entry]]);
    re[row] += added.real();
    im[row] += added.imag();
  }
  t = {hn::Load(D(), re), hn::Load(D(), im)};
}

/// t_i of Eq. 8 for the rows slice * kLanes + lane .. + Lanes - 1.
HWY_INLINE Z targets(const SlicedLayout& layout, const SlicedCouplings& couplings, const Complex* z,
                     Index slice, Index lane) {
  Z t{hn::Zero(D()), hn::Zero(D())};
  if (!couplings.anchor.empty()) t = load(couplings.anchor.data() + slice * kLanes + lane);
  for (std::size_t column = layout.column_begin[slice]; column < layout.column_begin[slice + 1];
       ++column) {
    const Z z_j = gather(z, layout.neighbor.data() + column * kLanes + lane);
    const Z a = load_column(couplings.direct.get() + column * 2 * kLanes + lane);
    const Z added = product(a, z_j);
    t = {hn::Add(t.re, added.re), hn::Add(t.im, added.im)};
  }
  if (couplings.reflecting_count[slice] > 0) add_reflecting(layout, couplings, z, slice, lane, t);
  return t;
}

HWY_INLINE V square(Z z) { return multiply_add(z.re, z.re, hn::Mul(z.im, z.im)); }

HWY_INLINE hn::Mask<D> has_direction(Z z) {
  return hn::Gt(square(z), hn::Set(D(), std::numeric_limits<float>::min()));
}

/// `z` / |z| where it has a direction, `otherwise` elsewhere.
HWY_INLINE Z normalized_or(Z z, Z otherwise, hn::Mask<D> directed) {
  const V scale = hn::Div(hn::Set(D(), 1.0f), hn::Sqrt(square(z)));
  return {hn::IfThenElse(directed, hn::Mul(z.re, scale), otherwise.re),
          hn::IfThenElse(directed, hn::Mul(z.im, scale), otherwise.im)};
}

void sweep_slices(const SlicedLayout& layout, const SlicedCouplings& couplings, Complex* z,
                  float over_relaxation, SliceRange range) {
  const V reach = hn::Set(D(), over_relaxation);
  for (Index slice = range.begin; slice < range.end; ++slice) {
    for (Index lane = 0; lane < kLanes; lane += lanes()) {
      const Z t = targets(layout, couplings, z, slice, lane);
      Complex* const z_i = z + slice * kLanes + lane;
      const Z before = load(z_i);
      const auto directed = has_direction(t);
      Z after = normalized_or(t, before, directed);
      if (over_relaxation != 1) {
        const Z beyond{multiply_add(reach, hn::Sub(after.re, before.re), before.re),
                       multiply_add(reach, hn::Sub(after.im, before.im), before.im)};
        after = normalized_or(beyond, before, directed);
      }
      store(after, z_i);
    }
  }
}

double relax_slices(const SlicedLayout& layout, const SlicedCouplings& couplings, Complex* z,
                    float strength, Complex* momentum, SliceRange range) {
  double drop = 0;
  const V s_m = hn::Set(D(), strength);
  for (Index slice = range.begin; slice < range.end; ++slice) {
    alignas(64) float lowered[kLanes];
    for (Index lane = 0; lane < kLanes; lane += lanes()) {
      const Index slot = slice * kLanes + lane;
      const Z t = targets(layout, couplings, z, slice, lane);
      const Z before = load(z + slot), m = load(momentum + slot);
      const Z pulled{hn::Add(t.re, m.re), hn::Add(t.im, m.im)};
      const auto directed = hn::And(has_direction(t), has_direction(pulled));
      const Z after = normalized_or(pulled, before, directed);
      store(after, z + slot);
      store({hn::Mul(s_m, hn::Sub(t.re, before.re)), hn::Mul(s_m, hn::Sub(t.im, before.im))},
            momentum + slot);
      hn::Store(multiply_add(hn::Sub(after.re, before.re), t.re,
                             hn::Mul(hn::Sub(after.im, before.im), t.im)),
                D(), lowered + lane);
    }
    drop += static_cast<double>(sum_of_lanes(lowered));
  }
  return drop;
}

/// conj(g_i) A g_j, conjugated and marked as gauge_slices says.
HWY_INLINE Z gauged_coupling(Z a, Z g_i, Z g_j) {
  const Z gauged = conjugate_product(g_i, product(a, g_j));
  const U bits;
  const Indices one = hn::Set(bits, 1u);
  const Indices conjugated_i = hn::And(hn::BitCast(bits, g_i.re), one);
  const Indices conjugated_j = hn::And(hn::BitCast(bits, g_j.re), one);
  const Indices mark = hn::Xor(conjugated_i, conjugated_j);
  const Indices marked = hn::Or(hn::AndNot(one, hn::BitCast(bits, gauged.re)), mark);
  const Indices conjugated = hn::Xor(hn::BitCast(bits, gauged.im), hn::ShiftLeft<31>(conjugated_i));
  return {hn::BitCast(D(), marked), hn::BitCast(D(), conjugated)};
}

void gauge_slices(const SlicedLayout& layout, const SlicedCouplings& couplings,
                  const Complex* gauge, Complex* gauged, SliceRange range) {
  const std::size_t first = std::size_t{layout.column_begin[range.begin]} * kLanes;
  for (Index slice = range.begin; slice < range.end; ++slice) {
    for (Index lane = 0; lane < kLanes; lane += lanes()) {
      const Z g_i = load(gauge + slice * kLanes + lane);
      for (std::size_t column = layout.column_begin[slice]; column < layout.column_begin[slice + 1];
           ++column) {
        const std::size_t entry = column * kLanes + lane;
        const Z g_j = gather(gauge, layout.neighbor.data() + entry);
        const Z a = load_column(couplings.direct.get() + column * 2 * kLanes + lane);
        store(gauged_coupling(a, g_i, g_j), gauged + (entry - first));
      }
    }
  }
}

HWY_INLINE hn::Mask<D> conjugate_mask(Z z) {
  const U bits;
  const Indices one = hn::Set(bits, 1u);
  return hn::RebindMask(D(), hn::Eq(hn::And(hn::BitCast(bits, z.re), one), one));
}

/// Direct couplings of scattered entries.
HWY_INLINE Z gather_couplings(const float* direct, Indices entry) {
  const hn::RebindToSigned<D> offset;
  const U bits;
  const Indices lane = hn::And(entry, hn::Set(bits, kLanes - 1));
  const auto re = hn::BitCast(offset, hn::Add(hn::ShiftLeft<1>(hn::Sub(entry, lane)), lane));
  return {hn::GatherIndex(D(), direct, re),
          hn::GatherIndex(D(), direct, hn::Add(re, hn::Set(offset, kLanes)))};
}

/// kLanes / Lanes parts of one group of gauge_members.
HWY_INLINE void gauge_group(const SlicedCouplings& couplings, const GaugeRounds& rounds,
                            Index group, Index lane, Complex* gauge) {
  const U bits;
  const V zero = hn::Zero(D());
  Z plain{zero, zero}, conjugated{zero, zero};
  for (Index round = rounds.round_begin[group]; round < rounds.round_begin[group + 1]; ++round) {
    const std::size_t place = std::size_t{round} * kLanes + lane;
    const Indices stored = hn::LoadU(bits, rounds.entry.data() + place);
    const auto none = hn::Eq(stored, hn::Set(bits, kNone));
    const Indices entry = hn::IfThenZeroElse(none, stored);
    const Z g = gather(gauge, rounds.from.data() + place);
    const Z a = gather_couplings(couplings.direct.get(), entry);
    const auto empty = hn::RebindMask(D(), none);
    const Z turned = product(a, g);
    const V re = hn::IfThenZeroElse(empty, turned.re), im = hn::IfThenZeroElse(empty, turned.im);
    const auto conjugate = conjugate_mask(g);
    plain = {hn::Add(plain.re, hn::IfThenZeroElse(conjugate, re)),
             hn::Add(plain.im, hn::IfThenZeroElse(conjugate, im))};
    conjugated = {hn::Add(conjugated.re, hn::IfThenElseZero(conjugate, re)),
                  hn::Add(conjugated.im, hn::IfThenElseZero(conjugate, im))};
  }
  const auto conjugate = hn::Gt(square(conjugated), square(plain));
  const Z sum{hn::IfThenElse(conjugate, conjugated.re, plain.re),
              hn::IfThenElse(conjugate, conjugated.im, plain.im)};
  const Z unit = normalized_or(sum, {hn::Set(D(), 1.0f), zero}, has_direction(sum));
  const Indices one = hn::Set(bits, 1u);
  const Indices cleared = hn::AndNot(one, hn::BitCast(bits, unit.re));
  const Indices flag = hn::IfThenElseZero(hn::RebindMask(bits, conjugate), one);
  alignas(64) Complex gauges[kLanes];
  store({hn::BitCast(D(), hn::Or(cleared, flag)), unit.im}, gauges);
  const Index* member = rounds.member.data() + group * kLanes + lane;
  for (Index l = 0; l < lanes(); ++l) {
    if (member[l] != kNone) gauge[member[l]] = gauges[l];
  }
}

void gauge_members(const SlicedCouplings& couplings, const GaugeRounds& rounds, Complex* gauge,
                   SliceRange groups) {
  for (Index group = groups.begin; group < groups.end; ++group) {
    for (Index lane = 0; lane < kLanes; lane += lanes()) {
      gauge_group(couplings, rounds, group, lane, gauge);
    }
  }
}

void sum_slices(const SlicedLayout& coarse, const Index* round_begin, const Index* round_entry,
                const Complex* gauged, float* direct, std::uint8_t* marked, SliceRange range) {
  const U bits;
  const V zero = hn::Zero(D());
  for (Index slice = range.begin; slice < range.end; ++slice) {
    Indices seen = hn::Zero(bits);
    for (Index column = coarse.column_begin[slice]; column < coarse.column_begin[slice + 1];
         ++column) {
      for (Index lane = 0; lane < kLanes; lane += lanes()) {
        Z sum{zero, zero};
        for (Index round = round_begin[column]; round < round_begin[column + 1]; ++round) {
          const Z c = gather(gauged, round_entry + std::size_t{round} * kLanes + lane);
          const auto conjugate = conjugate_mask(c);
          seen = hn::Or(seen, hn::BitCast(bits, c.re));
          sum = {hn::Add(sum.re, hn::IfThenZeroElse(conjugate, c.re)),
                 hn::Add(sum.im, hn::IfThenZeroElse(conjugate, c.im))};
        }
        float* const out = direct + std::size_t{column} * 2 * kLanes + lane;
        hn::StoreU(sum.re, D(), out);
        hn::StoreU(sum.im, D(), out + kLanes);
      }
    }
    const auto any = hn::Ne(hn::And(seen, hn::Set(bits, 1u)), hn::Zero(bits));
    marked[slice] = hn::AllFalse(bits, any) ? 0 : 1;
  }
}

void sum_marked_slice(const SlicedLayout& coarse, const Index* round_begin,
                      const Index* round_entry, const Complex* gauged, Complex* reflecting,
                      Index slice) {
  const V zero = hn::Zero(D());
  for (Index column = coarse.column_begin[slice]; column < coarse.column_begin[slice + 1];
       ++column, reflecting += kLanes) {
    for (Index lane = 0; lane < kLanes; lane += lanes()) {
      Z sum{zero, zero};
      for (Index round = round_begin[column]; round < round_begin[column + 1]; ++round) {
        const Z c = gather(gauged, round_entry + std::size_t{round} * kLanes + lane);
        const auto conjugate = conjugate_mask(c);
        sum = {hn::Add(sum.re, hn::IfThenElseZero(conjugate, c.re)),
               hn::Add(sum.im, hn::IfThenElseZero(conjugate, c.im))};
      }
      store(sum, reflecting + lane);
    }
  }
}

void prolong_slices(const Complex* gauge, const Index* coarse_slot, const Complex* coarse,
                    Complex* z, SliceRange range) {
  const U bits;
  for (Index slot = range.begin * kLanes; slot < range.end * kLanes; slot += lanes()) {
    const Z g = load(gauge + slot);
    Z z_coarse = gather(coarse, coarse_slot + slot);
    const Indices conjugated = hn::ShiftLeft<31>(hn::BitCast(bits, g.re));
    z_coarse.im = hn::BitCast(D(), hn::Xor(hn::BitCast(bits, z_coarse.im), conjugated));
    store(product(g, z_coarse), z + slot);
  }
}

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

void gauge_members(const SlicedCouplings& couplings, const GaugeRounds& rounds, Complex* gauge,
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
