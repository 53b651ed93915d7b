/// Levels that one process would have, cut into parts for many (docs/distributed.md).
#pragma once

#include <span>
#include <vector>

#include "brindle/distributed/levels/coupling_rows.h"
#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/phases/hierarchy.h"

namespace brindle {

/// A rank's part of a level. Nodes are its own, in the order that it has them in.
struct PlannedLevel {
  Index color_count = 0;
  Index slots_of_all = 0;        ///< of the whole level
  std::vector<Index> color;      ///< by node
  std::vector<Index> number;     ///< by node: in the whole level
  std::vector<Index> block_end;  ///< where blocks end, ascending, none of them empty
  /// Aggregate a, node a of the next level, has members begin[a] .. begin[a + 1] - 1, in the order
  /// in which they joined.
  std::vector<Index> begin{0}, member;
  std::vector<Index> block;  ///< by aggregate, ascending: the block that it grew in
};

/// A rank's parts of the finer levels; the last one has no aggregates.
struct LevelPlan {
  std::vector<PlannedLevel> levels;

  // Rows of the finest level, by node.
  std::vector<Index> source_rank;  ///< the rank that sets its couplings
  std::vector<Index> source_node;  ///< its own node there
  std::vector<Index> row_begin{0};
  /// Who owns the neighbours, which of its nodes they are, and their numbers in the whole; in the
  /// order of the source's edges.
  std::vector<Index> neighbor_rank, neighbor_node, neighbor_number;
};

/// What rank 0 has planned.
struct CutLevels {
  std::vector<LevelPlan> plans;  ///< by rank
  std::vector<Index> number_of;  ///< nodes of the last planned level, rank by rank: their numbers
};

/// The first levels of a hierarchy up to `last`, cut so that aggregates stay within a rank: with
/// everything that becomes one node of that level goes the rank that had most of it. `places` tells
/// where the ranks' rows stand in the finest level.
CutLevels cut_levels(const Hierarchy& hierarchy, std::size_t last,
                     std::span<const RowPlaces> places);

/// To the ranks from rank 0, which has all plans. Collective.
LevelPlan scatter_plans(Communicator& ranks, std::span<const LevelPlan> plans);

/// The finest level's graph. Rows are in the order that they have in the whole, so that sums have
/// the same bits.
struct PlannedGraph {
  RankGraph graph;
  std::vector<Index> neighbor;  ///< node here, in the order of the sources' edges
};

PlannedGraph graph_of(const LevelPlan& plan, const Communicator& ranks);

/// Brings the rows of a coarser level's graph into this order. Collective.
void order_rows(Communicator& ranks, const PlannedLevel& plan, RankGraph& graph);

}  // namespace brindle
