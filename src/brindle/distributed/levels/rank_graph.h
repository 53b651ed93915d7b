/// A rank's part of a distributed graph.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/distributed/halo.h"
#include "brindle/phases/coloring.h"
#include "brindle/types.h"

namespace brindle {

/// Nodes 0 .. own - 1 belong to the rank and have all their neighbours. Ghosts, the neighbours that
/// other ranks own, follow by owner, with empty rows. Adjacency is symmetric across ranks.
struct RankGraph {
  std::shared_ptr<const Adjacency> adjacency;
  Index own = 0;
  NodeHalo halo;

  Index node_count() const { return static_cast<Index>(adjacency->node_count()); }
  Index ghost_count() const { return node_count() - own; }
};

/// The nodes' numbers on their owners.
std::vector<Index> numbers_on_owners(Communicator& ranks, const RankGraph& graph);

/// The ranks that own the nodes.
std::vector<int> owners(const Communicator& ranks, const RankGraph& graph);

/// Whether own nodes are ghosts of other ranks.
std::vector<std::uint8_t> border_nodes(const RankGraph& graph);

/// The halo of a graph of groups of nodes, each within a rank. `group` has the group of every node,
/// or kNone; own nodes have groups below `own_groups`. Sets the groups of ghosts, which follow by
/// owner.
NodeHalo halo_of_groups(Communicator& ranks, const NodeHalo& halo, Index own_groups,
                        std::span<Index> group);

/// A colouring of the whole graph: ghosts have their owners' colours, and `color_count` is global.
/// On one rank it is `greedy_coloring`. Border nodes come first, in rounds: all ranks colour
/// simultaneously, and of two neighbours with the same colour on different ranks, one chooses again
/// (Bozdag et al. 2008).
Coloring rank_coloring(Communicator& ranks, const RankGraph& graph);

/// Splits each colour into three, so that slices contain one kind of node: inner nodes keep colour
/// c, border nodes get color_count + c, and ghosts 2 color_count + c.
Coloring with_sorts(const RankGraph& graph, const Coloring& coloring);

}  // namespace brindle
