/// Rows of couplings as ranks send them to each other.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "brindle/adjacency.h"
#include "brindle/phases/hierarchy.h"

namespace brindle {

/// Packs the couplings and anchors of some nodes of a level.
class RowPacker {
 public:
  RowPacker(std::shared_ptr<const Adjacency> adjacency, std::vector<Index> nodes);

  /// Overwrites `bytes`: direct couplings edge by edge, whether there are anchors, these node by
  /// node, then reflecting couplings.
  void pack(const Level& level, std::vector<std::byte>& bytes) const;

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

/// Makes couplings and anchors of a layout those of packed rows, which must be all of its rows that
/// count. `parts` and `places` have an entry per rank.
void load_rows(std::span<const std::vector<std::byte>> parts, std::span<const RowPlaces> places,
               const SlicedLayout& layout, SlicedCouplings& couplings);

}  // namespace brindle
