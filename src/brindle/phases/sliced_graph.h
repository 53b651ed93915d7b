/// The phase graph as solvers sweep it: contiguous colours, rows in slices of equal width
/// (docs/benchmarks.md, "Memory layout"). `load_couplings` fills it from a PhaseGraph, `couple`
/// (sliced_waves.h) directly from waves.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/phase_graph.h"
#include "brindle/phases/coloring.h"
#include "brindle/progress.h"
#include "brindle/types.h"
#include "brindle/waves/energy_sums.h"

namespace brindle {

/// Rows of a slice, which are updated together: the widest float vector of any processor.
inline constexpr Index kLanes = 16;
inline constexpr Index kNone = ~Index{0};

/// Slices begin .. end - 1.
struct SliceRange {
  Index begin;
  Index end;
};

/// The fewest slices per task.
inline constexpr std::size_t kSliceGrain = 64;

/// Calls `body(begin, end)` in parallel on disjoint ranges of `count` blocks. `progress` ticks
/// every few blocks.
template <class Body>
void for_blocks(std::size_t count, const Progress& progress, const Body& body) {
  constexpr std::size_t kBlocksPerTick = 32;
  if (!progress.is_heard()) return parallel_for(count, body, 1);
  for (std::size_t first = 0; first < count; first += kBlocksPerTick) {
    progress.tick();
    parallel_for(
        std::min(kBlocksPerTick, count - first),
        [&](std::size_t begin, std::size_t end) { body(first + begin, first + end); }, 1);
  }
}

/// The order of nodes and edges in memory (sliced ELLPACK, Kreutzer et al. 2014). Nodes are
/// renumbered to slots: by blocks of nearby nodes, then by colour, then by degree. The nodes of one
/// colour in one block fill whole slices of `kLanes` slots. A slice stores its rows' neighbours in
/// columns of `kLanes` entries, one entry per row. Shorter rows are padded with entries that point
/// to their own slot.
struct SlicedLayout {
  std::vector<Index> slot_of;         ///< node -> slot
  std::vector<Index> node_at;         ///< slot -> node, kNone for padding
  std::vector<SliceRange> ranges;     ///< slices of one colour in one block, colour by colour
  std::vector<Index> block_begin{0};  ///< block b owns slices block_begin[b] .. [b+1] - 1
  std::vector<Index> color_begin;  ///< colour c owns ranges color_begin[c] .. color_begin[c+1] - 1
  std::vector<Index>
      column_begin;             ///< slice s owns columns column_begin[s] .. column_begin[s+1] - 1
  std::vector<Index> neighbor;  ///< entry -> slot of the neighbour

  Index slot_count() const { return static_cast<Index>(node_at.size()); }
  Index slice_count() const { return slot_count() / kLanes; }
  Index block_count() const { return static_cast<Index>(block_begin.size()) - 1; }
  SliceRange block(Index b) const { return {block_begin[b], block_begin[b + 1]}; }
  Index color_count() const { return static_cast<Index>(color_begin.size()) - 1; }
  std::size_t entry_count() const { return neighbor.size(); }
  std::span<const SliceRange> ranges_of(Index color) const {
    return std::span(ranges).subspan(color_begin[color],
                                     color_begin[color + 1] - color_begin[color]);
  }

  /// Entries of a row are `first_entry(slot) + k * kLanes`, k from 0 to `width(slot)` - 1.
  std::size_t first_entry(Index slot) const {
    return std::size_t{column_begin[slot / kLanes]} * kLanes + slot % kLanes;
  }
  Index width(Index slot) const {
    return column_begin[slot / kLanes + 1] - column_begin[slot / kLanes];
  }
};

/// `order` is a permutation of the nodes in which neighbours are close together; empty: as
/// numbered. `block_ends` are the ends of blocks in this order, ascending, the last at its end;
/// empty: `equal_blocks`. Throws Cancelled if `progress` cancels.
SlicedLayout sliced_layout(const Adjacency& adjacency, const Coloring& coloring,
                           std::span<const Index> order = {},
                           std::span<const Index> block_ends = {}, const Progress& progress = {});

/// Ends of blocks of 2048 nodes: the phases of their neighbours fit the first cache.
std::vector<Index> equal_blocks(std::size_t nodes);

/// A reflecting coupling B of one entry.
struct ReflectingCoupling {
  Index entry;
  Complex b;
};

/// Couplings in a layout's entries. Direct couplings are dense: a column of kLanes entries takes 2
/// * kLanes floats, first all real, then all imaginary parts. Reflecting couplings are rare where
/// directions run alike, so each slice has a short list, in the order of entries. Sums of finer
/// couplings may give an entry both kinds. A slice's list has room for all its entries at
/// `reflecting + column_begin * kLanes`; unused pages are never touched.
struct SlicedCouplings {
  explicit SlicedCouplings(const SlicedLayout& layout);

  struct FreeStorage {
    void operator()(ReflectingCoupling* storage) const { ::operator delete(storage); }
  };

  std::unique_ptr<float[]> direct;
  std::unique_ptr<ReflectingCoupling[], FreeStorage> reflecting;
  std::vector<Index> reflecting_count;  ///< by slice
  std::vector<Complex> anchor;          ///< T_i by slot; empty for none

  static std::size_t real_part(std::size_t entry) {
    return (entry / kLanes) * (2 * kLanes) + entry % kLanes;
  }
  /// A of an entry.
  Complex direct_at(std::size_t entry) const {
    const float* re = direct.get() + real_part(entry);
    return {re[0], re[kLanes]};
  }
  void set_direct(std::size_t entry, Complex value) {
    float* re = direct.get() + real_part(entry);
    re[0] = value.real();
    re[kLanes] = value.imag();
  }
  /// All B of a slice.
  std::span<const ReflectingCoupling> reflecting_of(const SlicedLayout& layout, Index slice) const {
    return {reflecting.get() + std::size_t{layout.column_begin[slice]} * kLanes,
            reflecting_count[slice]};
  }
  /// B of an entry; zero if there is none.
  Complex reflecting_at(const SlicedLayout& layout, Index slice, std::size_t entry) const;
  /// Appends to the list of a slice; entries must ascend.
  void append_reflecting(const SlicedLayout& layout, Index slice,
                         const ReflectingCoupling& coupling) {
    reflecting[std::size_t{layout.column_begin[slice]} * kLanes + reflecting_count[slice]++] =
        coupling;
  }
};

/// Copies the couplings and anchors of a graph that has the layout's adjacency.
void load_couplings(const PhaseGraph& graph, const SlicedLayout& layout,
                    SlicedCouplings& couplings);

/// One coloured sweep of z_i = t_i / |t_i| (Eq. 8, 10) over all slots; nodes without a target keep
/// their phase. `over_relaxation` w, from 1 to below 2, goes farther: z_i + w (t_i / |t_i| - z_i),
/// scaled to length 1. No update raises the energy.
void sweep(const SlicedLayout& layout, const SlicedCouplings& couplings, std::span<Complex> z,
           float over_relaxation = 1);

/// The part of a sweep that updates the slots of one colour.
void sweep_color(const SlicedLayout& layout, const SlicedCouplings& couplings, std::span<Complex> z,
                 float over_relaxation, Index color);

/// Sums over the edges to all slots.
EnergySums energy_sums(const SlicedLayout& layout, const SlicedCouplings& couplings,
                       std::span<const Complex> z);

/// The energy of phases by slot, as defined by `energy` of phase_graph.h.
double energy(const SlicedLayout& layout, const SlicedCouplings& couplings,
              std::span<const Complex> z);

/// The momentum of the paper's relaxation.
struct Momentum {
  float strength;          ///< s_m of Eq. 11
  std::vector<Complex> m;  ///< m_i by slot, initially zero
};

/// Updates the slots of one colour by Eq. 10 and 11. Returns the decrease of the energy sum of Eq.
/// 5, anchors included. It is exactly Re(conj(z_i new - z_i old) t_i) per slot, since none are
/// neighbours.
double relax_color(const SlicedLayout& layout, const SlicedCouplings& couplings,
                   std::span<Complex> z, Momentum& momentum, Index color);

/// Slot order -> node order. `by_node` gets one entry per node.
void to_nodes(const SlicedLayout& layout, std::span<const Complex> by_slot,
              std::vector<Complex>& by_node);
std::vector<Complex> to_nodes(const SlicedLayout& layout, std::span<const Complex> by_slot);

/// Node order -> slot order. Slots without a node keep their value.
void to_slots(const SlicedLayout& layout, std::span<const Complex> by_node,
              std::span<Complex> by_slot);

}  // namespace brindle
