/// What a rank knows of a graph that all ranks hold together.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/distributed/halo.h"
#include "brindle/phases/coloring.h"
#include "brindle/types.h"

namespace brindle {

/// Nodes 0 .. own - 1 are the rank's own and have all their neighbours; ghosts, the neighbours that
/// other ranks own, come after them by owner, and their rows are empty. A node of one rank is a
/// neighbour of another's exactly if that is one of its.
struct RankGraph {
  std::shared_ptr<const Adjacency> adjacency;
  Index own = 0;
  NodeHalo halo;

  Index node_count() const { return static_cast<Index>(adjacency->node_count()); }
  Index ghost_count() const { return node_count() - own; }
};

/// The numbers that nodes have on their owners.
std::vector<Index> numbers_on_owners(Communicator& ranks, const RankGraph& graph);

/// The ranks that own the nodes.
std::vector<int> owners(const Communicator& ranks, const RankGraph& graph);

/// Which own nodes are ghosts of other ranks.
std::vector<std::uint8_t> border_nodes(const RankGraph& graph);

/// The halo of a graph whose nodes are groups of another's nodes, within a rank each. `group` has
/// that of every node, or kNone; own nodes have numbers below `own_groups`, and ghosts get theirs
/// here: their owners' groups follow the own ones, by owner.
NodeHalo halo_of_groups(Communicator& ranks, const NodeHalo& halo, Index own_groups,
                        std::span<Index> group);

/// A colouring of the whole graph: ghosts have the colours that they have on their owners, and
/// `color_count` is that of all ranks. That of one rank is `greedy_coloring`. Nodes at borders come
/// first, in rounds: all ranks colour at the same time, and of two neighbours on different ranks
/// that chose the same colour one chooses again (Bozdag et al. 2008).
Coloring rank_coloring(Communicator& ranks, const RankGraph& graph);

/// Three colours for each one, so that slices hold one sort of node: those of no interest to other
/// ranks keep theirs, c; border nodes get color_count + c, and ghosts 2 color_count + c.
Coloring with_sorts(const RankGraph& graph, const Coloring& coloring);

}  // namespace brindle
