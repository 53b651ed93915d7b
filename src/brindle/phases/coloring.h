/// Graph colouring: nodes of one colour are no neighbours and can be updated at the same time.
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/adjacency.h"

namespace brindle {

struct Coloring {
  std::vector<Index> color;  ///< one per node, below `color_count`; every colour is used
  Index color_count = 0;
};

/// Jones-Plassmann-Luby as in the paper's section 4 (Naumov et al. 2015): in every round the nodes
/// whose hash is larger than that of all uncoloured neighbours get the round's number as colour.
Coloring luby_coloring(const Adjacency& adjacency, std::uint32_t seed = 0);

/// The smallest colour that no neighbour has yet, in the order of node numbers. Fewer colours than
/// `luby_coloring`: at most the largest degree plus one.
Coloring greedy_coloring(const Adjacency& adjacency);

}  // namespace brindle
