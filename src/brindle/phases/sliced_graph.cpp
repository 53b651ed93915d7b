#include "brindle/phases/sliced_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

/// Sorting by degree only within windows keeps neighbours close in memory.
constexpr std::size_t kSortWindow = 1024;

/// Slices that one task updates at least.
constexpr std::size_t kSliceGrain = 64;

struct Targets {
  float re[kLanes];
  float im[kLanes];
};

/// t_i of Eq. 8 for the rows of one slice.
Targets targets(const SlicedLayout& layout, const SlicedCouplings& couplings,
                std::span<const Complex> z, Index slice) {
  Targets t{};
  if (!couplings.anchor.empty()) {
    for (Index lane = 0; lane < kLanes; ++lane) {
      t.re[lane] = couplings.anchor[slice * kLanes + lane].real();
      t.im[lane] = couplings.anchor[slice * kLanes + lane].imag();
    }
  }
  const bool reflects = couplings.slice_reflects[slice] != 0;
  for (std::size_t column = layout.column_begin[slice]; column < layout.column_begin[slice + 1];
       ++column) {
    const Index* neighbor = layout.neighbor.data() + column * kLanes;
    const float* a = couplings.direct.get() + column * 2 * kLanes;
    for (Index lane = 0; lane < kLanes; ++lane) {
      const Complex z_j = z[neighbor[lane]];
      t.re[lane] += a[lane] * z_j.real() - a[kLanes + lane] * z_j.imag();
      t.im[lane] += a[lane] * z_j.imag() + a[kLanes + lane] * z_j.real();
    }
    if (!reflects) continue;
    const float* b = couplings.reflecting.get() + column * 2 * kLanes;
    for (Index lane = 0; lane < kLanes; ++lane) {
      const Complex z_j = z[neighbor[lane]];
      t.re[lane] += b[lane] * z_j.real() + b[kLanes + lane] * z_j.imag();
      t.im[lane] += b[kLanes + lane] * z_j.real() - b[lane] * z_j.imag();
    }
  }
  return t;
}

/// t / |t|, or `otherwise` where t has no direction.
Complex normalized(float re, float im, Complex otherwise) {
  const float square = re * re + im * im;
  if (!(square > std::numeric_limits<float>::min())) return otherwise;
  const float scale = 1 / std::sqrt(square);
  return {re * scale, im * scale};
}

void sweep_slice(const SlicedLayout& layout, const SlicedCouplings& couplings, std::span<Complex> z,
                 Index slice) {
  const Targets t = targets(layout, couplings, z, slice);
  for (Index lane = 0; lane < kLanes; ++lane) {
    Complex& z_i = z[slice * kLanes + lane];
    z_i = normalized(t.re[lane], t.im[lane], z_i);
  }
}

double relax_slice(const SlicedLayout& layout, const SlicedCouplings& couplings,
                   std::span<Complex> z, Momentum& momentum, Index slice) {
  const Targets t = targets(layout, couplings, z, slice);
  double drop = 0;
  for (Index lane = 0; lane < kLanes; ++lane) {
    const Index slot = slice * kLanes + lane;
    if (layout.node_at[slot] == kNone) continue;
    const Complex target(t.re[lane], t.im[lane]);
    const Complex before = z[slot];
    const Complex pulled = target + momentum.m[slot];
    z[slot] = normalized(pulled.real(), pulled.imag(), before);
    momentum.m[slot] = momentum.strength * (target - before);
    drop +=
        (std::conj(std::complex<double>(z[slot] - before)) * std::complex<double>(target)).real();
  }
  return drop;
}

/// Nodes grouped by colour; within a colour sorted by degree in windows of the node order.
std::vector<std::vector<Index>> nodes_by_color(const Adjacency& adjacency,
                                               const Coloring& coloring) {
  std::vector<std::vector<Index>> groups(coloring.color_count);
  for (Index node = 0; node < adjacency.node_count(); ++node) {
    groups[coloring.color[node]].push_back(node);
  }
  const auto degree = [&](Index node) {
    return adjacency.offsets[node + 1] - adjacency.offsets[node];
  };
  for (auto& group : groups) {
    for (std::size_t begin = 0; begin < group.size(); begin += kSortWindow) {
      const std::size_t end = std::min(begin + kSortWindow, group.size());
      std::stable_sort(group.begin() + begin, group.begin() + end,
                       [&](Index a, Index b) { return degree(a) > degree(b); });
    }
  }
  return groups;
}

void assign_slots(SlicedLayout& layout, const std::vector<std::vector<Index>>& groups) {
  layout.color_begin.push_back(0);
  for (const auto& group : groups) {
    for (const Index node : group) {
      layout.slot_of[node] = layout.slot_count();
      layout.node_at.push_back(node);
    }
    while (layout.node_at.size() % kLanes != 0) layout.node_at.push_back(kNone);
    layout.color_begin.push_back(layout.slice_count());
  }
}

void fill_columns(SlicedLayout& layout, const Adjacency& adjacency) {
  layout.column_begin.assign(layout.slice_count() + 1, 0);
  for (Index slot = 0; slot < layout.slot_count(); ++slot) {
    const Index node = layout.node_at[slot];
    if (node == kNone) continue;
    Index& width = layout.column_begin[slot / kLanes + 1];
    width = std::max(width, adjacency.offsets[node + 1] - adjacency.offsets[node]);
  }
  for (Index slice = 0; slice < layout.slice_count(); ++slice) {
    layout.column_begin[slice + 1] += layout.column_begin[slice];
  }
  layout.neighbor.resize(std::size_t{layout.column_begin.back()} * kLanes);
  parallel_for(layout.slot_count(), [&](std::size_t begin, std::size_t end) {
    for (Index slot = static_cast<Index>(begin); slot < end; ++slot) {
      const Index node = layout.node_at[slot];
      std::size_t entry = layout.first_entry(slot);
      Index filled = 0;
      if (node != kNone) {
        for (const Index neighbor : adjacency.of(node)) {
          layout.neighbor[entry] = layout.slot_of[neighbor];
          entry += kLanes;
          ++filled;
        }
      }
      for (; filled < layout.width(slot); ++filled, entry += kLanes) layout.neighbor[entry] = slot;
    }
  });
}

}  // namespace

SlicedLayout sliced_layout(const Adjacency& adjacency, const Coloring& coloring) {
  SlicedLayout layout;
  layout.slot_of.resize(adjacency.node_count());
  layout.node_at.reserve(adjacency.node_count() + coloring.color_count * kLanes);
  assign_slots(layout, nodes_by_color(adjacency, coloring));
  fill_columns(layout, adjacency);
  return layout;
}

SlicedCouplings::SlicedCouplings(const SlicedLayout& layout)
    : direct(std::make_unique_for_overwrite<float[]>(2 * layout.entry_count())),
      reflecting(std::make_unique_for_overwrite<float[]>(2 * layout.entry_count())),
      slice_reflects(layout.slice_count()) {}

void SlicedCouplings::clear_slice(const SlicedLayout& layout, Index slice) {
  float* const data = direct.get();
  std::fill(data + std::size_t{layout.column_begin[slice]} * 2 * kLanes,
            data + std::size_t{layout.column_begin[slice + 1]} * 2 * kLanes, 0.0f);
  slice_reflects[slice] = 0;
}

void SlicedCouplings::add_reflecting(const SlicedLayout& layout, Index slice, std::size_t entry,
                                     Complex value) {
  float* const data = reflecting.get();
  if (!slice_reflects[slice]) {
    std::fill(data + std::size_t{layout.column_begin[slice]} * 2 * kLanes,
              data + std::size_t{layout.column_begin[slice + 1]} * 2 * kLanes, 0.0f);
    slice_reflects[slice] = 1;
  }
  add(data, entry, value);
}

void load_couplings(const PhaseGraph& graph, const SlicedLayout& layout,
                    SlicedCouplings& couplings) {
  parallel_for(
      layout.slice_count(),
      [&](std::size_t begin, std::size_t end) {
        for (Index slice = static_cast<Index>(begin); slice < end; ++slice) {
          couplings.clear_slice(layout, slice);
          for (Index slot = slice * kLanes; slot < (slice + 1) * kLanes; ++slot) {
            const Index node = layout.node_at[slot];
            if (node == kNone) continue;
            std::size_t entry = layout.first_entry(slot);
            for (Index edge = graph.adjacency->offsets[node];
                 edge < graph.adjacency->offsets[node + 1]; ++edge, entry += kLanes) {
              if (graph.reflecting[edge]) {
                couplings.add_reflecting(layout, slice, entry, graph.coupling[edge]);
              } else {
                SlicedCouplings::set(couplings.direct.get(), entry, graph.coupling[edge]);
              }
            }
          }
        }
      },
      kSliceGrain);
  couplings.anchor.clear();
  if (graph.anchor.empty()) return;
  couplings.anchor.resize(layout.slot_count());
  for (Index node = 0; node < graph.anchor.size(); ++node) {
    couplings.anchor[layout.slot_of[node]] = graph.anchor[node];
  }
}

void sweep(const SlicedLayout& layout, const SlicedCouplings& couplings, std::span<Complex> z) {
  for (Index color = 0; color < layout.color_count(); ++color) {
    const Index first = layout.color_begin[color];
    parallel_for(
        layout.color_begin[color + 1] - first,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t slice = begin; slice < end; ++slice) {
            sweep_slice(layout, couplings, z, first + static_cast<Index>(slice));
          }
        },
        kSliceGrain);
  }
}

double relax_color(const SlicedLayout& layout, const SlicedCouplings& couplings,
                   std::span<Complex> z, Momentum& momentum, Index color) {
  const Index first = layout.color_begin[color];
  return parallel_sum<double>(
      layout.color_begin[color + 1] - first,
      [&](std::size_t begin, std::size_t end) {
        double drop = 0;
        for (std::size_t slice = begin; slice < end; ++slice) {
          drop += relax_slice(layout, couplings, z, momentum, first + static_cast<Index>(slice));
        }
        return drop;
      },
      kSliceGrain);
}

std::vector<Complex> to_nodes(const SlicedLayout& layout, std::span<const Complex> by_slot) {
  std::vector<Complex> by_node(layout.slot_of.size());
  for (std::size_t node = 0; node < by_node.size(); ++node) {
    by_node[node] = by_slot[layout.slot_of[node]];
  }
  return by_node;
}

}  // namespace brindle
