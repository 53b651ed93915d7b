#include "brindle/phases/sliced_graph.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <new>
#include <numeric>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/phases/sliced_kernels.h"

namespace brindle {
namespace {

/// The fewest ranges (a colour in a block) per task.
constexpr std::size_t kRangeGrain = 4;

/// Sorts a block's nodes by colour, then by descending degree. Keys end with the place in the
/// block, which makes them unique.
void sort_block(const Adjacency& adjacency, const Coloring& coloring, std::span<Index> block) {
  constexpr std::uint64_t kDegrees = 1 << 16;  // larger degrees count as kDegrees - 1
  std::vector<std::uint64_t> keys(block.size());
  for (std::size_t n = 0; n < block.size(); ++n) {
    const Index degree = adjacency.offsets[block[n] + 1] - adjacency.offsets[block[n]];
    keys[n] = (coloring.color[block[n]] * kDegrees + (kDegrees - 1) -
               std::min<std::uint64_t>(degree, kDegrees - 1))
                  << 32 |
              n;
  }
  ranges::sort(keys);
  const std::vector<Index> before(block.begin(), block.end());
  for (std::size_t n = 0; n < block.size(); ++n) block[n] = before[static_cast<Index>(keys[n])];
}

/// Assigns slots to the nodes of a sorted block, and appends the ranges of its colours to `ranges`.
void assign_block(SlicedLayout& layout, const Coloring& coloring, std::span<const Index> block,
                  std::vector<std::vector<SliceRange>>& ranges) {
  for (std::size_t n = 0; n < block.size();) {
    const Index color = coloring.color[block[n]];
    const Index first = layout.slice_count();
    for (; n < block.size() && coloring.color[block[n]] == color; ++n) {
      layout.slot_of[block[n]] = layout.slot_count();
      layout.node_at.push_back(block[n]);
    }
    while (layout.node_at.size() % kLanes != 0) layout.node_at.push_back(kNone);
    ranges[color].push_back({first, layout.slice_count()});
  }
}

void assign_slots(SlicedLayout& layout, const Adjacency& adjacency, const Coloring& coloring,
                  std::span<const Index> order, std::span<const Index> block_ends,
                  const Progress& progress) {
  std::vector<Index> nodes(order.begin(), order.end());
  if (nodes.empty()) {
    nodes.resize(adjacency.node_count());
    std::iota(nodes.begin(), nodes.end(), Index{0});
  }
  const auto block = [&](std::size_t b) {
    const Index begin = b == 0 ? 0 : block_ends[b - 1];
    return std::span(nodes).subspan(begin, block_ends[b] - begin);
  };
  for_blocks(block_ends.size(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) sort_block(adjacency, coloring, block(b));
  });
  std::vector<std::vector<SliceRange>> ranges(coloring.color_count);
  for (std::size_t b = 0; b < block_ends.size(); ++b) {
    if (b % 32 == 0) progress.tick();
    assign_block(layout, coloring, block(b), ranges);
    layout.block_begin.push_back(layout.slice_count());
  }
  layout.color_begin.push_back(0);
  for (const auto& of_color : ranges) {
    layout.ranges.insert(layout.ranges.end(), of_color.begin(), of_color.end());
    layout.color_begin.push_back(static_cast<Index>(layout.ranges.size()));
  }
}

void fill_columns(SlicedLayout& layout, const Adjacency& adjacency, const Progress& progress) {
  layout.column_begin.assign(layout.slice_count() + 1, 0);
  for (Index slot = 0; slot < layout.slot_count(); ++slot) {
    if (slot % kReportSlice == 0) progress.tick();
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

std::vector<Index> equal_blocks(std::size_t nodes) {
  constexpr std::size_t kBlock = 2048;
  std::vector<Index> ends;
  for (std::size_t end = kBlock; end < nodes; end += kBlock) {
    ends.push_back(static_cast<Index>(end));
  }
  ends.push_back(static_cast<Index>(nodes));
  return ends;
}

SlicedLayout sliced_layout(const Adjacency& adjacency, const Coloring& coloring,
                           std::span<const Index> order, std::span<const Index> block_ends,
                           const Progress& progress) {
  SlicedLayout layout;
  layout.slot_of.resize(adjacency.node_count());
  layout.node_at.reserve(adjacency.node_count() + coloring.color_count * kLanes);
  assign_slots(layout, adjacency, coloring, order,
               block_ends.empty() ? equal_blocks(adjacency.node_count())
                                  : std::vector<Index>(block_ends.begin(), block_ends.end()),
               progress);
  fill_columns(layout, adjacency, progress);
  return layout;
}

SlicedCouplings::SlicedCouplings(const SlicedLayout& layout)
    : direct(std::make_unique<float[]>(2 * layout.entry_count())),
      // No constructor runs, because initialising complex numbers would touch every page.
      reflecting(static_cast<ReflectingCoupling*>(
          ::operator new(layout.entry_count() * sizeof(ReflectingCoupling)))),
      reflecting_count(layout.slice_count()) {}

Complex SlicedCouplings::reflecting_at(const SlicedLayout& layout, Index slice,
                                       std::size_t entry) const {
  for (const ReflectingCoupling& coupling : reflecting_of(layout, slice)) {
    if (coupling.entry == entry) return coupling.b;
  }
  return 0;
}

namespace {

/// Loads the direct couplings of one row; returns whether there are reflecting ones.
bool load_row(const PhaseGraph& graph, const SlicedLayout& layout, SlicedCouplings& couplings,
              Index slot) {
  const Index node = layout.node_at[slot];
  std::size_t entry = layout.first_entry(slot);
  const std::size_t end = entry + std::size_t{layout.width(slot)} * kLanes;
  bool reflects = false;
  if (node != kNone) {
    const std::vector<Index>& offsets = graph.adjacency->offsets;
    for (Index edge = offsets[node]; edge < offsets[node + 1]; ++edge, entry += kLanes) {
      const bool direct = graph.reflecting[edge] == 0;
      couplings.set_direct(entry, direct ? graph.coupling[edge] : Complex(0));
      reflects |= !direct;
    }
  }
  for (; entry < end; entry += kLanes) couplings.set_direct(entry, 0);
  return reflects;
}

/// Loads reflecting couplings column by column, which is the order of entries.
void load_reflecting(const PhaseGraph& graph, const SlicedLayout& layout,
                     SlicedCouplings& couplings, Index slice) {
  const std::vector<Index>& offsets = graph.adjacency->offsets;
  const Index columns = layout.column_begin[slice + 1] - layout.column_begin[slice];
  for (Index k = 0; k < columns; ++k) {
    for (Index slot = slice * kLanes; slot < (slice + 1) * kLanes; ++slot) {
      const Index node = layout.node_at[slot];
      if (node == kNone || offsets[node] + k >= offsets[node + 1]) continue;
      const Index edge = offsets[node] + k;
      if (!graph.reflecting[edge]) continue;
      const auto entry = static_cast<Index>(layout.first_entry(slot) + std::size_t{k} * kLanes);
      couplings.append_reflecting(layout, slice, {entry, graph.coupling[edge]});
    }
  }
}

void load_slice(const PhaseGraph& graph, const SlicedLayout& layout, SlicedCouplings& couplings,
                Index slice) {
  couplings.reflecting_count[slice] = 0;
  bool reflects = false;
  for (Index slot = slice * kLanes; slot < (slice + 1) * kLanes; ++slot) {
    reflects |= load_row(graph, layout, couplings, slot);
  }
  if (reflects) load_reflecting(graph, layout, couplings, slice);
}

}  // namespace

void load_couplings(const PhaseGraph& graph, const SlicedLayout& layout,
                    SlicedCouplings& couplings) {
  parallel_for(
      layout.slice_count(),
      [&](std::size_t begin, std::size_t end) {
        for (Index slice = static_cast<Index>(begin); slice < end; ++slice) {
          load_slice(graph, layout, couplings, slice);
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

void sweep(const SlicedLayout& layout, const SlicedCouplings& couplings, std::span<Complex> z,
           float over_relaxation) {
  for (Index color = 0; color < layout.color_count(); ++color) {
    sweep_color(layout, couplings, z, over_relaxation, color);
  }
}

void sweep_color(const SlicedLayout& layout, const SlicedCouplings& couplings, std::span<Complex> z,
                 float over_relaxation, Index color) {
  const auto ranges = layout.ranges_of(color);
  parallel_for(
      ranges.size(),
      [&](std::size_t begin, std::size_t end) {
        for (const SliceRange& range : ranges.subspan(begin, end - begin)) {
          kernels::sweep_slices(layout, couplings, z.data(), over_relaxation, range);
        }
      },
      kRangeGrain);
}

namespace {

void add_edge(EnergySums& sums, std::complex<double> z_i, std::complex<double> coupling,
              std::complex<double> z_j) {
  const double w = std::sqrt(std::norm(coupling));
  sums.weight += w;
  sums.energy += 0.5 * (w - (std::conj(z_i) * coupling * z_j).real());
}

EnergySums energy_of_slice(const SlicedLayout& layout, const SlicedCouplings& couplings,
                           std::span<const Complex> z, Index slice) {
  EnergySums sums;
  for (std::size_t entry = std::size_t{layout.column_begin[slice]} * kLanes;
       entry < std::size_t{layout.column_begin[slice + 1]} * kLanes; ++entry) {
    add_edge(sums, z[slice * kLanes + entry % kLanes], couplings.direct_at(entry),
             z[layout.neighbor[entry]]);
  }
  for (const auto& [entry, b] : couplings.reflecting_of(layout, slice)) {
    add_edge(sums, z[slice * kLanes + entry % kLanes], b, std::conj(z[layout.neighbor[entry]]));
  }
  return sums;
}

}  // namespace

EnergySums energy_sums(const SlicedLayout& layout, const SlicedCouplings& couplings,
                       std::span<const Complex> z) {
  return parallel_sum<EnergySums>(
      layout.slice_count(),
      [&](std::size_t begin, std::size_t end) {
        EnergySums part;
        for (Index slice = static_cast<Index>(begin); slice < end; ++slice) {
          part = part + energy_of_slice(layout, couplings, z, slice);
        }
        return part;
      },
      kSliceGrain);
}

double energy(const SlicedLayout& layout, const SlicedCouplings& couplings,
              std::span<const Complex> z) {
  return energy_sums(layout, couplings, z).relative();
}

double relax_color(const SlicedLayout& layout, const SlicedCouplings& couplings,
                   std::span<Complex> z, Momentum& momentum, Index color) {
  const auto ranges = layout.ranges_of(color);
  return parallel_sum<double>(
      ranges.size(),
      [&](std::size_t begin, std::size_t end) {
        double drop = 0;
        for (const SliceRange& range : ranges.subspan(begin, end - begin)) {
          drop += kernels::relax_slices(layout, couplings, z.data(), momentum.strength,
                                        momentum.m.data(), range);
        }
        return drop;
      },
      kRangeGrain);
}

void to_nodes(const SlicedLayout& layout, std::span<const Complex> by_slot,
              std::vector<Complex>& by_node) {
  by_node.resize(layout.slot_of.size());
  parallel_for(by_node.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      by_node[node] = by_slot[layout.slot_of[node]];
    }
  });
}

std::vector<Complex> to_nodes(const SlicedLayout& layout, std::span<const Complex> by_slot) {
  std::vector<Complex> by_node;
  to_nodes(layout, by_slot, by_node);
  return by_node;
}

void to_slots(const SlicedLayout& layout, std::span<const Complex> by_node,
              std::span<Complex> by_slot) {
  for (std::size_t node = 0; node < by_node.size(); ++node) {
    by_slot[layout.slot_of[node]] = by_node[node];
  }
}

}  // namespace brindle
