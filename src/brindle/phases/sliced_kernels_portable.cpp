#include <algorithm>
#include <cmath>
#include <limits>

#include "brindle/phases/sliced_kernels.h"
#include "brindle/phases/sliced_waves.h"

namespace brindle::portable {
namespace {

struct Lanes {
  float re[kLanes];
  float im[kLanes];
};

/// t_i of Eq. 8 for the rows of one slice.
Lanes targets(const SlicedLayout& layout, const SlicedCouplings& couplings, const Complex* z,
              Index slice) {
  Lanes t{};
  if (!couplings.anchor.empty()) {
    for (Index lane = 0; lane < kLanes; ++lane) {
      t.re[lane] = couplings.anchor[slice * kLanes + lane].real();
      t.im[lane] = couplings.anchor[slice * kLanes + lane].imag();
    }
  }
  for (std::size_t column = layout.column_begin[slice]; column < layout.column_begin[slice + 1];
       ++column) {
    const Index* neighbor = layout.neighbor.data() + column * kLanes;
    const float* a = couplings.direct.get() + column * 2 * kLanes;
    for (Index lane = 0; lane < kLanes; ++lane) {
      const Complex z_j = z[neighbor[lane]];
      t.re[lane] += a[lane] * z_j.real() - a[kLanes + lane] * z_j.imag();
      t.im[lane] += a[lane] * z_j.imag() + a[kLanes + lane] * z_j.real();
    }
  }
  for (const auto& [entry, b] : couplings.reflecting_of(layout, slice)) {
    const Complex added = b * std::conj(z[layout.neighbor[entry]]);
    t.re[entry % kLanes] += added.real();
    t.im[entry % kLanes] += added.imag();
  }
  return t;
}

bool has_direction(float re, float im) {
  return re * re + im * im > std::numeric_limits<float>::min();
}

Complex normalized(float re, float im) {
  const float scale = 1 / std::sqrt(re * re + im * im);
  return {re * scale, im * scale};
}

struct EdgeShift {
  float cosine;  ///< <d_i, d_j>
  float turns;   ///< Phi_ji / 2 pi
};

EdgeShift edge_shift(const SlicedWave& j, const SlicedWave& i, bool trapezoid) {
  const auto dot = [](const float* a, const float* b) {
    return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]);
  };
  const float e[3] = {i.position[0] - j.position[0], i.position[1] - j.position[1],
                      i.position[2] - j.position[2]};
  const float cosine = dot(i.direction, j.direction);
  const float along_j = dot(e, j.direction), along_i = dot(e, i.direction);
  const float along = along_j + (cosine < 0 ? -along_i : along_i);
  const float distance = along / (trapezoid ? 2 : 1 + std::abs(cosine));
  return {cosine, i.root_frequency * j.root_frequency * distance};
}

/// exp(2 pi i turns): Taylor series about the nearest half turn, as the vectors have it.
Complex unit(float turns) {
  const float rest = turns - std::nearbyint(turns);
  const float half_turns = std::nearbyint(rest + rest);
  const float x = (rest - half_turns * 0.5f) * 6.283185307f;
  const float x2 = x * x;
  float sine = -2.505210839e-8f;
  for (const float c : {2.755731922e-6f, -1.984126984e-4f, 8.333333333e-3f, -0.1666666667f, 1.0f}) {
    sine = sine * x2 + c;
  }
  float cosine = 2.087675699e-9f;
  for (const float c :
       {-2.755731922e-7f, 2.480158730e-5f, -1.388888889e-3f, 4.166666667e-2f, -0.5f, 1.0f}) {
    cosine = cosine * x2 + c;
  }
  return half_turns == 0 ? Complex(cosine, sine * x) : Complex(-cosine, -(sine * x));
}

}  // namespace

void couple_slices(const SlicedLayout& layout, const SlicedWave* waves, PhaseShiftKind kind,
                   const float* entry_weights, SlicedCouplings& couplings, float* degree,
                   SliceRange range) {
  const bool trapezoid = kind == PhaseShiftKind::trapezoid;
  for (Index slice = range.begin; slice < range.end; ++slice) {
    couplings.reflecting_count[slice] = 0;
    std::fill_n(degree + slice * kLanes, kLanes, 0.0f);
    for (std::size_t entry = std::size_t{layout.column_begin[slice]} * kLanes;
         entry < std::size_t{layout.column_begin[slice + 1]} * kLanes; ++entry) {
      const Index i = slice * kLanes + static_cast<Index>(entry % kLanes);
      const Index j = layout.neighbor[entry];
      couplings.set_direct(entry, 0);
      if (i == j) continue;
      const EdgeShift shift = edge_shift(waves[j], waves[i], trapezoid);
      float weight = std::abs(shift.cosine);
      if (entry_weights) weight *= entry_weights[entry];
      degree[i] += weight;
      if (shift.cosine < 0) {
        couplings.append_reflecting(layout, slice,
                                    {static_cast<Index>(entry), -weight * unit(-shift.turns)});
      } else {
        couplings.set_direct(entry, weight * unit(shift.turns));
      }
    }
  }
}

void sweep_slices(const SlicedLayout& layout, const SlicedCouplings& couplings, Complex* z,
                  float over_relaxation, SliceRange range) {
  for (Index slice = range.begin; slice < range.end; ++slice) {
    const Lanes t = targets(layout, couplings, z, slice);
    for (Index lane = 0; lane < kLanes; ++lane) {
      if (!has_direction(t.re[lane], t.im[lane])) continue;
      Complex& z_i = z[slice * kLanes + lane];
      const Complex peak = normalized(t.re[lane], t.im[lane]);
      const Complex beyond = z_i + over_relaxation * (peak - z_i);
      z_i = over_relaxation == 1 ? peak : normalized(beyond.real(), beyond.imag());
    }
  }
}

double relax_slices(const SlicedLayout& layout, const SlicedCouplings& couplings, Complex* z,
                    float strength, Complex* momentum, SliceRange range) {
  double drop = 0;
  for (Index slice = range.begin; slice < range.end; ++slice) {
    const Lanes t = targets(layout, couplings, z, slice);
    float lowered[kLanes];
    for (Index lane = 0; lane < kLanes; ++lane) {
      const Index slot = slice * kLanes + lane;
      const Complex before = z[slot];
      const Complex pulled = Complex(t.re[lane], t.im[lane]) + momentum[slot];
      if (has_direction(t.re[lane], t.im[lane]) && has_direction(pulled.real(), pulled.imag())) {
        z[slot] = normalized(pulled.real(), pulled.imag());
      }
      momentum[slot] = strength * (Complex(t.re[lane], t.im[lane]) - before);
      lowered[lane] = (z[slot].real() - before.real()) * t.re[lane] +
                      (z[slot].imag() - before.imag()) * t.im[lane];
    }
    drop += static_cast<double>(sum_of_lanes(lowered));
  }
  return drop;
}

void gauge_slices(const SlicedLayout& layout, const SlicedCouplings& couplings,
                  const Complex* gauge, Complex* gauged, SliceRange range) {
  const std::size_t first = std::size_t{layout.column_begin[range.begin]} * kLanes;
  for (Index slice = range.begin; slice < range.end; ++slice) {
    for (std::size_t entry = std::size_t{layout.column_begin[slice]} * kLanes;
         entry < std::size_t{layout.column_begin[slice + 1]} * kLanes; ++entry) {
      const Complex g_i = gauge[slice * kLanes + entry % kLanes];
      const Complex g_j = gauge[layout.neighbor[entry]];
      const Complex c = std::conj(g_i) * (couplings.direct_at(entry) * g_j);
      gauged[entry - first] = with_conjugate_bit(conjugate_bit(g_i) ? std::conj(c) : c,
                                                 conjugate_bit(g_i) != conjugate_bit(g_j));
    }
  }
}

void gauge_members(const SlicedCouplings& couplings, const GaugeRounds& rounds, Complex* gauge,
                   SliceRange groups) {
  for (Index m = groups.begin * kLanes; m < groups.end * kLanes; ++m) {
    if (rounds.member[m] == kNone) continue;
    Complex sums[2] = {0, 0};
    for (Index round = rounds.round_begin[m / kLanes]; round < rounds.round_begin[m / kLanes + 1];
         ++round) {
      const std::size_t place = std::size_t{round} * kLanes + m % kLanes;
      if (rounds.entry[place] == kNone) continue;
      const Complex from = gauge[rounds.from[place]];
      sums[conjugate_bit(from)] += couplings.direct_at(rounds.entry[place]) * from;
    }
    const bool conjugate = std::norm(sums[1]) > std::norm(sums[0]);
    const Complex sum = sums[conjugate];
    gauge[rounds.member[m]] = with_conjugate_bit(
        has_direction(sum.real(), sum.imag()) ? normalized(sum.real(), sum.imag()) : Complex(1),
        conjugate);
  }
}

void sum_slices(const SlicedLayout& coarse, const Index* round_begin, const Index* round_entry,
                const Complex* gauged, float* direct, std::uint8_t* marked, SliceRange range) {
  for (Index slice = range.begin; slice < range.end; ++slice) {
    marked[slice] = 0;
    for (Index column = coarse.column_begin[slice]; column < coarse.column_begin[slice + 1];
         ++column) {
      Lanes sum{};
      for (Index round = round_begin[column]; round < round_begin[column + 1]; ++round) {
        for (Index lane = 0; lane < kLanes; ++lane) {
          const Complex c = gauged[round_entry[std::size_t{round} * kLanes + lane]];
          marked[slice] |= static_cast<std::uint8_t>(conjugate_bit(c));
          if (conjugate_bit(c)) continue;
          sum.re[lane] += c.real();
          sum.im[lane] += c.imag();
        }
      }
      std::copy_n(sum.re, kLanes, direct + std::size_t{column} * 2 * kLanes);
      std::copy_n(sum.im, kLanes, direct + std::size_t{column} * 2 * kLanes + kLanes);
    }
  }
}

void sum_marked_slice(const SlicedLayout& coarse, const Index* round_begin,
                      const Index* round_entry, const Complex* gauged, Complex* reflecting,
                      Index slice) {
  for (Index column = coarse.column_begin[slice]; column < coarse.column_begin[slice + 1];
       ++column, reflecting += kLanes) {
    std::fill_n(reflecting, kLanes, Complex(0));
    for (Index round = round_begin[column]; round < round_begin[column + 1]; ++round) {
      for (Index lane = 0; lane < kLanes; ++lane) {
        const Complex c = gauged[round_entry[std::size_t{round} * kLanes + lane]];
        if (conjugate_bit(c)) reflecting[lane] += c;
      }
    }
  }
}

void prolong_slices(const Complex* gauge, const Index* coarse_slot, const Complex* coarse,
                    Complex* z, SliceRange range) {
  for (Index slot = range.begin * kLanes; slot < range.end * kLanes; ++slot) {
    const Complex coarse_z = coarse[coarse_slot[slot]];
    z[slot] = gauge[slot] * (conjugate_bit(gauge[slot]) ? std::conj(coarse_z) : coarse_z);
  }
}

}  // namespace brindle::portable
