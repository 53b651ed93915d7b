/// Rows of couplings as ranks send them to each other.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "brindle/phases/hierarchy.h"
#include "brindle/types.h"

namespace brindle {

/// Packs the couplings and anchors of some nodes of a level.
class RowPacker {
 public:
  RowPacker(std::shared_ptr<const Adjacency> adjacency, std::vector<Index> nodes);

  /// Overwrites `bytes`: direct couplings edge by edge, whether there are anchors, these node by
  /// node, then reflecting couplings.
  void pack(const Level& level, std::vector<std::byte>& bytes) const;

  const std::vector<Index>& nodes() const { return nodes_; }

  /// Calls `visit(packed edge, B)` for all reflecting couplings of the rows.
  template <class Visit>
  void for_each_reflection(const Level& level, const Visit& visit) const {
    const SlicedLayout& layout = level.layout();
    for (Index slice = 0; slice < layout.slice_count(); ++slice) {
      for (const auto& [entry, b] : level.couplings.reflecting_of(layout, slice)) {
        const Index node = layout.node_at[slice * kLanes + entry % kLanes];
        if (node >= first_edge_.size() || first_edge_[node] == kNone) continue;
        visit(first_edge_[node] + entry / kLanes - layout.column_begin[slice], b);
      }
    }
  }

 private:
  std::shared_ptr<const Adjacency> adjacency_;
  std::vector<Index> nodes_;
  std::vector<Index> first_edge_;  ///< by node of the level, among the packed ones, or kNone
};

/// Where the rows that one rank has packed stand in a layout.
struct RowPlaces {
  std::vector<Index> slot;           ///< by row
  std::vector<Index> edge_begin{0};  ///< row r has edges edge_begin[r] .. edge_begin[r + 1] - 1
  std::vector<Index> entry;          ///< by edge

  /// Appends a row whose edges lead to these slots. Throws Error if the layout has no such edge.
  void add(const SlicedLayout& layout, Index row_slot, std::span<const Index> neighbor_slots);
};

/// Rows of a level of this rank, which need no packing.
struct LocalRows {
  const Level& level;
  const RowPacker& rows;
  const RowPlaces& places;
};

/// Makes couplings and anchors of a layout those of packed rows and local ones, which together must
/// be all of its rows that count. `parts` and `places` have an entry per rank; empty parts are
/// passed over.
void load_rows(std::span<const std::vector<std::byte>> parts, std::span<const RowPlaces> places,
               const SlicedLayout& layout, SlicedCouplings& couplings,
               const LocalRows* local = nullptr);

}  // namespace brindle
