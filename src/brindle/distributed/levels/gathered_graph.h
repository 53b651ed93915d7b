/// The connectivity of a graph that all ranks hold together, on rank 0.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brindle/distributed/levels/rank_graph.h"

namespace brindle {

struct GatheredGraph {
  std::vector<Index> first_node;  ///< on all ranks: nodes of lower ranks, and of all at the end
  // On rank 0 alone.
  std::vector<Index> number_of;  ///< by node, rank by rank
  /// The neighbours of node n, rank by rank, are neighbors[begin[n]] .. neighbors[begin[n + 1] -
  /// 1], rank by rank too, as the rank has them.
  std::vector<Index> begin{0}, neighbors;

  Index node_count() const { return static_cast<Index>(begin.size()) - 1; }
  std::span<const Index> of(Index node) const {
    return std::span(neighbors).subspan(begin[node], begin[node + 1] - begin[node]);
  }

  /// Under the nodes' numbers.
  Adjacency adjacency() const;
};

/// Collective. `number_of` is of rank 0 alone; empty: numbers are rank by rank.
GatheredGraph gather_graph(Communicator& ranks, const RankGraph& graph,
                           std::vector<Index> number_of = {});

/// On rank 0: of all ranks' own nodes the order of their numbers in the whole, `ids`. Collective.
std::vector<Index> numbers_by_id(Communicator& ranks, std::span<const std::uint64_t> ids);

}  // namespace brindle
