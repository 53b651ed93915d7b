/// Levels of merged nodes: the entries of a sparse symmetric matrix on each level, and the coarser
/// entries to which they add.
#pragma once

#include <span>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// The target of an entry whose ends have the same parent.
inline constexpr Index kInsideParent = ~Index{0};

/// Nodes per block. Rows of a block are relaxed in sequence, blocks in parallel.
inline constexpr Index kRowBlock = 1024;

/// Nodes of other processes (ghosts, `MultigridPeers`) have no rows here. They come last: their
/// columns start at `size()`.
struct RowLevel {
  std::vector<Index> offsets{0};  ///< nodes + 1
  std::vector<Index> columns;     ///< of entries off the diagonal; the row's own block first
  std::vector<Index> outside;     ///< per row: its first entry of another block or process
  std::vector<Index> target;      ///< entry -> entry of the coarser level, or kInsideParent
  std::vector<Index> parent;      ///< node -> node of the coarser level
  std::vector<Index> children;    ///< node I of the coarser level has children[I] .. [I + 1] - 1
  // The coarsest level has neither targets nor parents nor children.
  Index others = 0;  ///< number of ghosts

  Index size() const { return static_cast<Index>(offsets.size() - 1); }
  Index size_with_others() const { return size() + others; }
  Index block_count() const { return (size() + kRowBlock - 1) / kRowBlock; }
};

/// All levels, and the places of nodes in the finest.
struct RowLevels {
  std::vector<RowLevel> levels;  ///< the finest first; never empty
  std::vector<Index> node_at;    ///< place in the finest level -> node
  std::vector<Index> place_of;   ///< node -> place
};

/// Up to four strongly connected nodes become one node of the next level. The children of a node
/// are adjacent in memory on every level. `strengths` has a number of 0 or above per directed edge.
/// Throws Cancelled if `progress` cancels.
RowLevels row_levels(const Adjacency& adjacency, std::span<const float> strengths,
                     const Progress& progress = {});

/// Levels of at most this many nodes are not merged further.
inline constexpr Index kFewestNodes = 32;

/// A graph with strengths of edges. Ghosts come last and have no rows.
struct StrengthGraph {
  std::vector<Index> offsets{0};
  std::vector<Index> neighbors;
  std::vector<float> strengths;
  Index others = 0;

  Index size() const { return static_cast<Index>(offsets.size() - 1); }
};

/// The group of each node. Groups of ghosts come last, too.
struct Grouping {
  std::vector<Index> parent;  ///< by node, ghosts last
  Index count = 0;            ///< number of own groups
  Index others = 0;           ///< number of groups of ghosts
};

/// `row_levels` step by step, so that ranks can exchange groups.
class RowLevelMaker {
 public:
  explicit RowLevelMaker(StrengthGraph finest);

  /// The coarsest graph so far.
  const StrengthGraph& coarsest() const { return graphs_.back(); }

  /// Groups the own nodes of the coarsest graph; parents of ghosts are not yet set.
  Grouping grouped(const Progress& progress = {}) const;

  /// Adds a level whose nodes are the groups.
  void merge(Grouping grouping, const Progress& progress = {});

  /// All levels. The places of ghosts are their numbers.
  RowLevels made(const Progress& progress = {});

  /// Node -> place in a level, after `made`.
  std::span<const Index> places_of(std::size_t level) const { return places_of_[level]; }

 private:
  std::vector<StrengthGraph> graphs_;
  std::vector<Grouping> groupings_;
  std::vector<std::vector<Index>> places_of_;
};

}  // namespace brindle
