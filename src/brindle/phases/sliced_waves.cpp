#include "brindle/phases/sliced_waves.h"

#include <cmath>

#include "brindle/base/error.h"
#include "brindle/base/parallel.h"
#include "brindle/phases/sliced_kernels.h"

namespace brindle {
namespace {

/// Slices that one task couples at least.
constexpr std::size_t kSliceGrain = 64;

}  // namespace

void load_waves(const SlicedLayout& layout, std::span<const Vec3> positions,
                std::span<const Vec3> directions, std::span<const float> frequencies,
                std::vector<SlicedWave>& waves) {
  waves.resize(layout.slot_count());
  parallel_for(layout.slot_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Index node = layout.node_at[slot];
      if (node == kNone) continue;
      const Vec3& p = positions[node];
      const Vec3& d = directions[node];
      waves[slot] = {{p.x(), p.y(), p.z()}, std::sqrt(frequencies[node]), {d.x(), d.y(), d.z()}, 0};
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

}  // namespace brindle
