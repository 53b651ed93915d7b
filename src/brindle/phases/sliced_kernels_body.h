// The kernels that sliced_kernels.h declares, written once for portable code and for vectors. The
// including source defines, in its own namespace,
//   Real    kReals floats, with + - * and /,
//   Truth   the result of comparing Reals,
//   Bits    kReals unsigned 32-bit numbers, with & | and ^,
//   real(float), zero(), negative, absolute, square_root, nearest (whole number), less, chosen,
//   zero_where(Truth, Real), zero_unless(Truth, Real), both, any, for_each(Truth, body(lane)),
//   bits(uint32), ascending_bits(first), bits_of(Real), real_of(Bits), equal, without(Bits, mask),
//   times_four, to_sign (the lowest bit becomes the highest), sign_if_odd(whole Real),
//   load, store (aligned), load_unaligned, store_unaligned, load_bits, store_bits,
//   Numbers { Real re, im; }, complex numbers, one per lane, and
//   load_complex(from), store_complex(Numbers, to), gathered(from, index) and
//   gathered_couplings(direct, entries): Numbers of couplings, of the first one for kNone.
// There is no include guard, because each instruction set includes this file again.

namespace {

/// Part of a column of couplings: first all real, then all imaginary parts.
BRINDLE_KERNEL Numbers load_column(const float* column) {
  return {load_unaligned(column), load_unaligned(column + kLanes)};
}

BRINDLE_KERNEL Numbers operator+(const Numbers& a, const Numbers& b) {
  return {a.re + b.re, a.im + b.im};
}

BRINDLE_KERNEL Numbers operator-(const Numbers& a, const Numbers& b) {
  return {a.re - b.re, a.im - b.im};
}

BRINDLE_KERNEL Numbers operator*(Real factor, const Numbers& z) {
  return {factor * z.re, factor * z.im};
}

BRINDLE_KERNEL Numbers operator*(const Numbers& a, const Numbers& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// conj(a) b.
BRINDLE_KERNEL Numbers conjugate_product(const Numbers& a, const Numbers& b) {
  return {a.re * b.re + a.im * b.im, a.re * b.im - a.im * b.re};
}

BRINDLE_KERNEL Real square(const Numbers& z) { return z.re * z.re + z.im * z.im; }

BRINDLE_KERNEL Truth has_direction(const Numbers& z) {
  return less(real(std::numeric_limits<float>::min()), square(z));
}

BRINDLE_KERNEL Numbers chosen(Truth truth, const Numbers& yes, const Numbers& no) {
  return {chosen(truth, yes.re, no.re), chosen(truth, yes.im, no.im)};
}

/// z / |z| where z has a direction, otherwise `otherwise`.
BRINDLE_KERNEL Numbers normalized_or(const Numbers& z, const Numbers& otherwise, Truth directed) {
  const Real scale = real(1) / square_root(square(z));
  return chosen(directed, scale * z, otherwise);
}

/// exp(2 pi i turns): Taylor series about the nearest half turn, errors below 3e-7.
BRINDLE_KERNEL Numbers unit(Real turns) {
  const Real rest = turns - nearest(turns);
  const Real half_turns = nearest(rest + rest);
  const Real x = (rest - half_turns * real(0.5f)) * real(6.283185307f);
  const Real x2 = x * x;
  Real sine = real(-2.505210839e-8f);
  for (const float c : {2.755731922e-6f, -1.984126984e-4f, 8.333333333e-3f, -0.1666666667f, 1.0f}) {
    sine = sine * x2 + real(c);
  }
  Real cosine = real(2.087675699e-9f);
  for (const float c :
       {-2.755731922e-7f, 2.480158730e-5f, -1.388888889e-3f, 4.166666667e-2f, -0.5f, 1.0f}) {
    cosine = cosine * x2 + real(c);
  }
  // An odd number of half turns changes both signs.
  const Bits sign = sign_if_odd(half_turns);
  return {real_of(bits_of(cosine) ^ sign), real_of(bits_of(sine * x) ^ sign)};
}

/// Whether a gauge or a gauged coupling has the conjugate bit.
BRINDLE_KERNEL Truth is_conjugate(const Numbers& z) {
  return equal(bits_of(z.re) & bits(1), bits(1));
}

// ---- Couplings of waves ------------------------------------------------------------------------

/// Waves, one per lane. Flat, so that compilers keep it in registers.
struct WaveNumbers {
  Real x, y, z;
  Real root_frequency;
  Real dx, dy, dz;
};

BRINDLE_KERNEL WaveNumbers gathered_waves(const SlicedWave* waves, const Index* slot) {
  // A wave is four pairs of floats.
  const auto* pairs = reinterpret_cast<const Complex*>(waves);
  alignas(64) Index first[kLanes];
  store_bits(times_four(load_bits(slot)), first);
  const Numbers xy = gathered(pairs, first), zf = gathered(pairs + 1, first);
  const Numbers d = gathered(pairs + 2, first), d3 = gathered(pairs + 3, first);
  return {xy.re, xy.im, zf.re, zf.im, d.re, d.im, d3.re};
}

BRINDLE_KERNEL WaveNumbers load_waves(const SlicedWave* waves) {
  alignas(64) Index slot[kLanes];
  store_bits(ascending_bits(0), slot);
  return gathered_waves(waves, slot);
}

/// <(x, y, z), d> with the direction of a wave.
BRINDLE_KERNEL Real along(const WaveNumbers& wave, Real x, Real y, Real z) {
  return x * wave.dx + (y * wave.dy + z * wave.dz);
}

/// Phi_ji / 2 pi of Eq. 1 with the aligned distance of phase_shift.h, or the trapezoid's.
BRINDLE_KERNEL Real shift_in_turns(const WaveNumbers& j, const WaveNumbers& i, Real cosine,
                                   Truth reflects, bool trapezoid) {
  const Real ex = i.x - j.x, ey = i.y - j.y, ez = i.z - j.z;
  const Real along_j = along(j, ex, ey, ez), along_i = along(i, ex, ey, ez);
  const Real along_both = along_j + chosen(reflects, negative(along_i), along_i);
  const Real distance = along_both / (trapezoid ? real(2) : real(1) + absolute(cosine));
  return i.root_frequency * j.root_frequency * distance;
}

/// Computes the couplings of kReals entries of a column; returns their weights.
BRINDLE_KERNEL Real couple_entries(const SlicedLayout& layout, const WaveNumbers& i,
                                   const SlicedWave* waves, bool trapezoid,
                                   const float* entry_weights, Index slice, std::size_t entry,
                                   SlicedCouplings& couplings) {
  const Index* const neighbor = layout.neighbor.data() + entry;
  const auto own = static_cast<Index>(slice * kLanes + entry % kLanes);
  const Truth filling = equal(load_bits(neighbor), ascending_bits(own));
  const WaveNumbers j = gathered_waves(waves, neighbor);
  const Real cosine = along(j, i.dx, i.dy, i.dz);
  const Truth reflects = less(cosine, zero());
  const Numbers e = unit(shift_in_turns(j, i, cosine, reflects, trapezoid));
  Real weight = zero_where(filling, absolute(cosine));
  if (entry_weights) weight = weight * load_unaligned(entry_weights + entry);
  const Numbers coupling = weight * e;
  float* const column = couplings.direct.get() + SlicedCouplings::real_part(entry);
  store_unaligned(zero_where(reflects, coupling.re), column);
  store_unaligned(zero_where(reflects, coupling.im), column + kLanes);
  if (!any(reflects)) return weight;
  // B = -w exp(-i Phi), where A = w exp(i Phi).
  alignas(64) float b_re[kLanes], b_im[kLanes];
  store(negative(coupling.re), b_re);
  store(coupling.im, b_im);
  for_each(reflects, [&](Index lane) {
    couplings.append_reflecting(
        layout, slice, {static_cast<Index>(entry + lane), Complex(b_re[lane], b_im[lane])});
  });
  return weight;
}

// ---- Targets of nodes --------------------------------------------------------------------------

/// The targets of a slice's rows.
struct SliceTargets {
  alignas(64) float re[kLanes];
  alignas(64) float im[kLanes];

  BRINDLE_KERNEL Numbers at(Index lane) const { return {load(re + lane), load(im + lane)}; }
};

/// t_i of Eq. 8 without the reflecting couplings.
BRINDLE_KERNEL Numbers direct_targets(const SlicedLayout& layout, const SlicedCouplings& couplings,
                                      const Complex* z, Index slice, Index lane) {
  Numbers t{zero(), zero()};
  if (!couplings.anchor.empty()) {
    t = load_complex(couplings.anchor.data() + slice * kLanes + lane);
  }
  for (std::size_t column = layout.column_begin[slice]; column < layout.column_begin[slice + 1];
       ++column) {
    const Numbers z_j = gathered(z, layout.neighbor.data() + column * kLanes + lane);
    t = t + load_column(couplings.direct.get() + column * 2 * kLanes + lane) * z_j;
  }
  return t;
}

/// t_i of Eq. 8 for all rows of a slice.
BRINDLE_KERNEL void find_targets(const SlicedLayout& layout, const SlicedCouplings& couplings,
                                 const Complex* z, Index slice, SliceTargets& targets) {
  for (Index lane = 0; lane < kLanes; lane += kReals) {
    const Numbers t = direct_targets(layout, couplings, z, slice, lane);
    store(t.re, targets.re + lane);
    store(t.im, targets.im + lane);
  }
  for (const auto& [entry, b] : couplings.reflecting_of(layout, slice)) {
    const Complex added = b * std::conj(z[layout.neighbor[entry]]);
    targets.re[entry % kLanes] += added.real();
    targets.im[entry % kLanes] += added.imag();
  }
}

// ---- Gauges and sums ---------------------------------------------------------------------------

/// conj(g_i) A g_j, conjugated and marked as GaugeSlices describes.
BRINDLE_KERNEL Numbers gauged_coupling(const Numbers& a, const Numbers& g_i, const Numbers& g_j) {
  const Numbers gauged = conjugate_product(g_i, a * g_j);
  const Bits one = bits(1);
  const Bits conjugated_i = bits_of(g_i.re) & one, conjugated_j = bits_of(g_j.re) & one;
  return {real_of(without(bits_of(gauged.re), one) | (conjugated_i ^ conjugated_j)),
          real_of(bits_of(gauged.im) ^ to_sign(conjugated_i))};
}

/// kReals members of one group of gauge_members.
BRINDLE_KERNEL void gauge_group(const SlicedCouplings& couplings, const GaugeSchedule& rounds,
                                Index group, Index lane, Complex* gauge) {
  Numbers plain{zero(), zero()}, conjugated{zero(), zero()};
  for (Index round = rounds.round_begin[group]; round < rounds.round_begin[group + 1]; ++round) {
    const std::size_t place = std::size_t{round} * kLanes + lane;
    const Truth empty = equal(load_bits(rounds.entry.data() + place), bits(kNone));
    const Numbers g = gathered(gauge, rounds.from.data() + place);
    const Numbers a = gathered_couplings(couplings.direct.get(), rounds.entry.data() + place);
    const Numbers turned = a * g;
    const Real re = zero_where(empty, turned.re), im = zero_where(empty, turned.im);
    const Truth conjugate = is_conjugate(g);
    plain = plain + Numbers{zero_where(conjugate, re), zero_where(conjugate, im)};
    conjugated = conjugated + Numbers{zero_unless(conjugate, re), zero_unless(conjugate, im)};
  }
  const Truth conjugate = less(square(plain), square(conjugated));
  const Numbers sum = chosen(conjugate, conjugated, plain);
  const Numbers found = normalized_or(sum, {real(1), zero()}, has_direction(sum));
  const Bits bit = bits_of(zero_unless(conjugate, real_of(bits(1))));
  alignas(64) Complex gauges[kLanes];
  store_complex({real_of(without(bits_of(found.re), bits(1)) | bit), found.im}, gauges);
  const Index* const member = rounds.member.data() + group * kLanes + lane;
  for (Index l = 0; l < kReals; ++l) {
    if (member[l] != kNone) gauge[member[l]] = gauges[l];
  }
}

}  // namespace

void couple_slices(const SlicedLayout& layout, const SlicedWave* waves, PhaseShiftKind kind,
                   const float* entry_weights, SlicedCouplings& couplings, float* degree,
                   SliceRange range) {
  const bool trapezoid = kind == PhaseShiftKind::trapezoid;
  for (Index slice = range.begin; slice < range.end; ++slice) {
    couplings.reflecting_count[slice] = 0;
    float* const sum = degree + slice * kLanes;
    std::fill_n(sum, kLanes, 0.0f);
    for (std::size_t column = layout.column_begin[slice]; column < layout.column_begin[slice + 1];
         ++column) {
      for (Index lane = 0; lane < kLanes; lane += kReals) {
        const WaveNumbers i = load_waves(waves + slice * kLanes + lane);
        const Real weight = couple_entries(layout, i, waves, trapezoid, entry_weights, slice,
                                           column * kLanes + lane, couplings);
        store_unaligned(load_unaligned(sum + lane) + weight, sum + lane);
      }
    }
  }
}

void sweep_slices(const SlicedLayout& layout, const SlicedCouplings& couplings, Complex* z,
                  float over_relaxation, SliceRange range) {
  SliceTargets targets;
  for (Index slice = range.begin; slice < range.end; ++slice) {
    find_targets(layout, couplings, z, slice, targets);
    for (Index lane = 0; lane < kLanes; lane += kReals) {
      Complex* const z_i = z + slice * kLanes + lane;
      const Numbers t = targets.at(lane), before = load_complex(z_i);
      const Truth directed = has_direction(t);
      Numbers after = normalized_or(t, before, directed);
      if (over_relaxation != 1) {
        const Numbers beyond = real(over_relaxation) * (after - before) + before;
        after = normalized_or(beyond, before, directed);
      }
      store_complex(after, z_i);
    }
  }
}

double relax_slices(const SlicedLayout& layout, const SlicedCouplings& couplings, Complex* z,
                    float strength, Complex* momentum, SliceRange range) {
  double drop = 0;
  SliceTargets targets;
  for (Index slice = range.begin; slice < range.end; ++slice) {
    find_targets(layout, couplings, z, slice, targets);
    alignas(64) float lowered[kLanes];
    for (Index lane = 0; lane < kLanes; lane += kReals) {
      const Index slot = slice * kLanes + lane;
      const Numbers t = targets.at(lane), before = load_complex(z + slot);
      const Numbers pulled = t + load_complex(momentum + slot);
      const Truth directed = both(has_direction(t), has_direction(pulled));
      const Numbers after = normalized_or(pulled, before, directed);
      store_complex(after, z + slot);
      store_complex(real(strength) * (t - before), momentum + slot);
      const Numbers way = after - before;
      store(way.re * t.re + way.im * t.im, lowered + lane);
    }
    drop += static_cast<double>(sum_of_lanes(lowered));
  }
  return drop;
}

void gauge_slices(const SlicedLayout& layout, const SlicedCouplings& couplings,
                  const Complex* gauge, Complex* gauged, SliceRange range) {
  const std::size_t first = std::size_t{layout.column_begin[range.begin]} * kLanes;
  for (Index slice = range.begin; slice < range.end; ++slice) {
    for (Index lane = 0; lane < kLanes; lane += kReals) {
      const Numbers g_i = load_complex(gauge + slice * kLanes + lane);
      for (std::size_t column = layout.column_begin[slice]; column < layout.column_begin[slice + 1];
           ++column) {
        const std::size_t entry = column * kLanes + lane;
        const Numbers g_j = gathered(gauge, layout.neighbor.data() + entry);
        const Numbers a = load_column(couplings.direct.get() + column * 2 * kLanes + lane);
        store_complex(gauged_coupling(a, g_i, g_j), gauged + (entry - first));
      }
    }
  }
}

void gauge_members(const SlicedCouplings& couplings, const GaugeSchedule& rounds, Complex* gauge,
                   SliceRange groups) {
  for (Index group = groups.begin; group < groups.end; ++group) {
    for (Index lane = 0; lane < kLanes; lane += kReals) {
      gauge_group(couplings, rounds, group, lane, gauge);
    }
  }
}

void sum_slices(const SlicedLayout& coarse, const Index* round_begin, const Index* round_entry,
                const Complex* gauged, float* direct, std::uint8_t* marked, SliceRange range) {
  for (Index slice = range.begin; slice < range.end; ++slice) {
    Bits seen = bits(0);
    for (Index column = coarse.column_begin[slice]; column < coarse.column_begin[slice + 1];
         ++column) {
      for (Index lane = 0; lane < kLanes; lane += kReals) {
        Numbers sum{zero(), zero()};
        for (Index round = round_begin[column]; round < round_begin[column + 1]; ++round) {
          const Numbers c = gathered(gauged, round_entry + std::size_t{round} * kLanes + lane);
          const Truth conjugate = is_conjugate(c);
          seen = seen | bits_of(c.re);
          sum = sum + Numbers{zero_where(conjugate, c.re), zero_where(conjugate, c.im)};
        }
        float* const out = direct + std::size_t{column} * 2 * kLanes + lane;
        store_unaligned(sum.re, out);
        store_unaligned(sum.im, out + kLanes);
      }
    }
    marked[slice] = any(equal(seen & bits(1), bits(1))) ? 1 : 0;
  }
}

void sum_marked_slice(const SlicedLayout& coarse, const Index* round_begin,
                      const Index* round_entry, const Complex* gauged, Complex* reflecting,
                      Index slice) {
  for (Index column = coarse.column_begin[slice]; column < coarse.column_begin[slice + 1];
       ++column, reflecting += kLanes) {
    for (Index lane = 0; lane < kLanes; lane += kReals) {
      Numbers sum{zero(), zero()};
      for (Index round = round_begin[column]; round < round_begin[column + 1]; ++round) {
        const Numbers c = gathered(gauged, round_entry + std::size_t{round} * kLanes + lane);
        const Truth conjugate = is_conjugate(c);
        sum = sum + Numbers{zero_unless(conjugate, c.re), zero_unless(conjugate, c.im)};
      }
      store_complex(sum, reflecting + lane);
    }
  }
}

void prolong_slices(const Complex* gauge, const Index* coarse_slot, const Complex* coarse,
                    Complex* z, SliceRange range) {
  for (Index slot = range.begin * kLanes; slot < range.end * kLanes; slot += kReals) {
    const Numbers g = load_complex(gauge + slot);
    Numbers z_coarse = gathered(coarse, coarse_slot + slot);
    z_coarse.im = real_of(bits_of(z_coarse.im) ^ to_sign(bits_of(g.re)));
    store_complex(g * z_coarse, z + slot);
  }
}
