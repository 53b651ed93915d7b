/// Nodes merged level by level: where the entries of a sparse symmetric matrix lie, and which are
/// summed into which.
#pragma once

#include <span>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// An entry that no coarser one takes: both its ends have one parent.
inline constexpr Index kInsideParent = ~Index{0};

/// Rows of nodes of a block are relaxed one after the other, blocks at the same time.
inline constexpr Index kRowBlock = 1024;

/// Nodes of other processes, where there are any (`RowPeers`), have no rows, and come after all
/// that have: columns of theirs are those from `size()` on.
struct RowLevel {
  std::vector<Index> offsets{0};  ///< nodes + 1
  std::vector<Index> columns;     ///< an entry beside the diagonal each, those of the row's own
                                  ///< block first
  std::vector<Index> outside;     ///< per row the first entry of another block, or process
  std::vector<Index> target;      ///< entry -> entry of the coarser level, or kInsideParent
  std::vector<Index> parent;      ///< node -> node of the coarser level
  std::vector<Index> children;    ///< those of node I of the coarser level: children[I] ..
                                  ///< children[I + 1] - 1
  // The coarsest level has neither targets nor parents nor children.
  Index others = 0;  ///< nodes of other processes

  Index size() const { return static_cast<Index>(offsets.size() - 1); }
  Index size_with_others() const { return size() + others; }
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
RowLevels row_levels(const Adjacency& adjacency, std::span<const float> strengths,
                     const Progress& progress = {});

/// Fewer nodes are not worth another level.
inline constexpr Index kFewestNodes = 32;

/// The rows of a graph's nodes. Those of `others` come after them as neighbours.
struct StrengthGraph {
  std::vector<Index> offsets{0};
  std::vector<Index> neighbors;
  std::vector<float> strengths;
  Index others = 0;

  Index size() const { return static_cast<Index>(offsets.size() - 1); }
};

/// Which nodes are merged into which. Groups of others come after the own ones, too.
struct Grouping {
  std::vector<Index> parent;  ///< by node, others last
  Index count = 0;            ///< of own groups
  Index others = 0;           ///< of groups that others have
};

/// What `row_levels` does, level by level, for those who have something to say in between.
class RowLevelMaker {
 public:
  explicit RowLevelMaker(StrengthGraph finest);

  /// The coarsest graph so far.
  const StrengthGraph& coarsest() const { return graphs_.back(); }

  /// How its own nodes are best merged; the parents of others mean nothing yet.
  Grouping grouped(const Progress& progress = {}) const;

  /// Makes the groups the nodes of another level.
  void merge(Grouping grouping, const Progress& progress = {});

  /// All levels. Nodes of others have their numbers as places.
  RowLevels made(const Progress& progress = {});

  /// Node -> place in a level, after `made`.
  std::span<const Index> places_of(std::size_t level) const { return places_of_[level]; }

 private:
  std::vector<StrengthGraph> graphs_;
  std::vector<Grouping> groupings_;
  std::vector<std::vector<Index>> places_of_;
};

}  // namespace brindle
