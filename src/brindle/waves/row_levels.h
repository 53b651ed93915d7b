/// Nodes merged level by level: where the entries of a sparse symmetric matrix lie, and which are
/// summed into which.
#pragma once

#include <span>
#include <vector>

#include "brindle/adjacency.h"

namespace brindle {

/// An entry that no coarser one takes: both its ends have one parent.
inline constexpr Index kInsideParent = ~Index{0};

/// Rows of nodes of a block are relaxed one after the other, blocks at the same time.
inline constexpr Index kRowBlock = 1024;

struct RowLevel {
  std::vector<Index> offsets{0};  ///< nodes + 1
  std::vector<Index> columns;     ///< an entry beside the diagonal each, those of the row's own
                                  ///< block first
  std::vector<Index> outside;     ///< per row the first entry of another block
  std::vector<Index> target;      ///< entry -> entry of the coarser level, or kInsideParent
  std::vector<Index> parent;      ///< node -> node of the coarser level
  std::vector<Index> children;    ///< those of node I of the coarser level: children[I] ..
                                  ///< children[I + 1] - 1
  // The coarsest level has neither targets nor parents nor children.

  Index size() const { return static_cast<Index>(offsets.size() - 1); }
  Index block_count() const { return (size() + kRowBlock - 1) / kRowBlock; }
};

struct RowLevels {
  std::vector<RowLevel> levels;  ///< the finest first; never empty
  std::vector<Index> node_at;    ///< place in the finest level -> node
  std::vector<Index> place_of;   ///< node -> place
};

/// Aggregates of up to four nodes that are joined strongly become one node of the next level; the
/// children of a node lie side by side, level by level, so that what is close together lies close
/// together. `strengths` has a number of 0 or above per directed edge.
RowLevels row_levels(const Adjacency& adjacency, std::span<const float> strengths);

}  // namespace brindle
