/// Aggregates of a level that all ranks hold together.
#pragma once

#include "brindle/distributed/levels/level_plan.h"
#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/phases/aggregation.h"
#include "brindle/phases/hierarchy.h"

namespace brindle {

/// Aggregates, and the graph of which they are the nodes.
struct RankAggregates {
  Aggregates aggregates;  ///< of own nodes, then those of ghosts, as their owners have them
  RankGraph coarse;
};

/// The own aggregates of a level: `grow_aggregates`, and, where there are other ranks, one more for
/// every node all of whose neighbours are ghosts. Couplings of ghosts are not looked at.
Aggregates own_aggregates(const Communicator& ranks, const RankGraph& graph, const Level& level);

/// Own aggregates that were planned, on a level with the planned blocks.
Aggregates planned_aggregates(const SlicedLayout& layout, const PlannedLevel& plan);

/// Completes own aggregates by those of the ghosts. Couplings between ranks then are summed like
/// all others.
RankAggregates with_ghosts(Communicator& ranks, const RankGraph& graph, const Level& level,
                           Aggregates own);

}  // namespace brindle
