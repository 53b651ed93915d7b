/// Aggregates: the nodes of a level that become one node of the next coarser level
/// (docs/method.md, "Multilevel solver").
#pragma once

#include <vector>

#include "brindle/phases/sliced_graph.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// The aggregate of each slot. Aggregates are numbered in the order of growth, block by block.
struct Aggregates {
  std::vector<Index> aggregate;       ///< slot -> aggregate or kNone
  std::vector<Index> begin{0};        ///< aggregate a has members begin[a] .. begin[a+1] - 1
  std::vector<Index> member;          ///< slots, in the order in which they joined
  std::vector<Index> block_begin{0};  ///< block b has aggregates block_begin[b] .. [b+1] - 1

  Index count() const { return static_cast<Index>(begin.size()) - 1; }
};

/// Aggregates grow one by one, in the order of slots. The free neighbour with the strongest
/// coupling to the aggregate, by sum max(|A|, |B|) / sqrt(deg), joins until there are four members.
/// Aggregates stay within a block so that its gauges and sums stay in the cache; blocks grow in
/// parallel. Single nodes join the aggregate of their most strongly coupled neighbour, if possible
/// in their block. Nodes without coupling have no aggregate. Throws Cancelled if `progress`
/// cancels.
Aggregates grow_aggregates(const SlicedLayout& layout, const SlicedCouplings& couplings,
                           const Progress& progress = {});

/// The neighbours of each aggregate, ascending: aggregates with neighbouring members.
Adjacency coarse_adjacency(const SlicedLayout& layout, const Aggregates& aggregates);

/// The layout of the coarser level for this colouring. Each block holds the aggregates of a few
/// whole blocks of the finer level.
SlicedLayout coarse_layout(const Aggregates& aggregates, const Adjacency& adjacency,
                           const Coloring& coloring);

}  // namespace brindle
