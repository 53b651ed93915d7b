/// Aggregates: which nodes of a level become one node of the next coarser one.
#pragma once

#include <vector>

#include "brindle/phases/sliced_graph.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// Nodes that grow into one aggregate.
inline constexpr Index kAggregateSize = 4;

/// Which aggregate each slot belongs to; aggregates are numbered in the order in which they grew,
/// block by block of the layout.
struct Aggregates {
  std::vector<Index> aggregate;       ///< slot -> aggregate or kNone
  std::vector<Index> begin{0};        ///< aggregate a has members begin[a] .. begin[a+1] - 1
  std::vector<Index> member;          ///< slots, in the order in which they joined
  std::vector<Index> block_begin{0};  ///< block b has aggregates block_begin[b] .. [b+1] - 1

  Index count() const { return static_cast<Index>(begin.size()) - 1; }
};

/// Aggregates grow one by one, in the order of slots: the free neighbour that is most
/// strongly coupled to the aggregate, by sum max(|A|, |B|) / sqrt(deg), joins it until it has
/// `kAggregateSize` members. Only nodes of one block grow together, so that a block's gauges and
/// sums stay in the cache, and blocks grow at the same time. Nodes left alone join the neighbour's
/// aggregate that they are most strongly coupled to, in their block if there is one; nodes without
/// any coupling stay outside. Throws Cancelled if `progress` asks for it.
Aggregates grow_aggregates(const SlicedLayout& layout, const SlicedCouplings& couplings,
                           const Progress& progress = {});

/// Aggregates are neighbours if some of their members are.
Adjacency coarse_adjacency(const SlicedLayout& layout, const Aggregates& aggregates);

}  // namespace brindle
