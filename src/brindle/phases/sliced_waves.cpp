#include "brindle/phases/sliced_waves.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/phases/sliced_kernels.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

bool same(const SlicedWave& a, const SlicedWave& b) {
  return ranges::equal(a.position, b.position) && a.root_frequency == b.root_frequency &&
         ranges::equal(a.direction, b.direction);
}

bool is_reversed(const SlicedWave& a, const SlicedWave& b) {
  return a.direction[0] * b.direction[0] + a.direction[1] * b.direction[1] +
             a.direction[2] * b.direction[2] <
         0;
}

/// The phase or momentum of the same wave with the opposite direction.
Complex reversed(Complex z) { return -std::conj(z); }

}  // namespace

bool load_waves(const SlicedLayout& layout, std::span<const Vec3> positions,
                std::span<const Vec3> directions, std::span<const float> frequencies,
                std::vector<SlicedWave>& waves, std::span<const SlicedWave> last,
                std::span<Complex> z, std::span<Complex> m) {
  waves.resize(layout.slot_count());
  if (last.empty()) z = m = {};
  std::atomic<bool> changed = last.empty();
  parallel_for(layout.slot_count(), [&](std::size_t begin, std::size_t end) {
    bool changed_here = false;
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Index node = layout.node_at[slot];
      if (node == kNone) continue;
      const Vec3& p = positions[node];
      const Vec3& d = directions[node];
      const SlicedWave now{
          {p.x(), p.y(), p.z()}, std::sqrt(frequencies[node]), {d.x(), d.y(), d.z()}, 0};
      if (!last.empty()) {
        changed_here = changed_here || !same(last[slot], now);
        if (is_reversed(last[slot], now)) {
          if (!z.empty()) z[slot] = reversed(z[slot]);
          if (!m.empty()) m[slot] = reversed(m[slot]);
        }
      }
      waves[slot] = now;
    }
    if (changed_here) changed.store(true, std::memory_order_relaxed);
  });
  return changed;
}

void turn_phases(std::span<const SlicedWave> from, std::span<const SlicedWave> to,
                 std::span<Complex> z) {
  parallel_for(z.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      if (is_reversed(from[slot], to[slot])) z[slot] = reversed(z[slot]);
    }
  });
}

std::vector<float> sliced_weights(const SlicedLayout& layout, const Adjacency& adjacency,
                                  std::span<const float> edge_weights) {
  std::vector<float> weights(layout.entry_count());
  for (Index node = 0; node < adjacency.node_count(); ++node) {
    std::size_t entry = layout.first_entry(layout.slot_of[node]);
    for (Index edge = adjacency.offsets[node]; edge < adjacency.offsets[node + 1]; ++edge) {
      weights[entry] = edge_weights[edge];
      entry += kLanes;
    }
  }
  return weights;
}

void couple(const SlicedLayout& layout, std::span<const SlicedWave> waves, PhaseShiftKind kind,
            std::span<const float> entry_weights, SlicedCouplings& couplings,
            std::span<float> degree) {
  if (kind == PhaseShiftKind::common_source) {
    throw Error("couplings of the paper's common source are made by build_phase_graph");
  }
  parallel_for(
      layout.slice_count(),
      [&](std::size_t begin, std::size_t end) {
        kernels::couple_slices(layout, waves.data(), kind,
                               entry_weights.empty() ? nullptr : entry_weights.data(), couplings,
                               degree.data(), {static_cast<Index>(begin), static_cast<Index>(end)});
      },
      kSliceGrain);
}

void couple_waves(const SlicedLayout& layout, const Adjacency& adjacency, const WaveSet& waves,
                  PhaseShiftKind kind, std::span<const float> edge_weights,
                  SlicedCouplings& couplings) {
  check_coupled_waves(adjacency, waves, edge_weights);
  std::vector<SlicedWave> sliced;
  load_waves(layout, waves.positions, waves.directions, waves.frequencies, sliced);
  std::vector<float> weights;
  if (!edge_weights.empty()) weights = sliced_weights(layout, adjacency, edge_weights);
  std::vector<float> degree(layout.slot_count());
  couple(layout, sliced, kind, weights, couplings, degree);
}

}  // namespace brindle
