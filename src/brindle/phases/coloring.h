/// Graph colouring: nodes of one colour are not neighbours, so they can be updated in parallel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

struct Coloring {
  std::vector<Index> color;  ///< one per node, below `color_count`; every colour is used
  Index color_count = 0;
};

inline constexpr Index kUncolored = ~Index{0};

/// Colours nodes one after the other; some may have colours before.
class GreedyColorer {
 public:
  /// `adjacency` must outlive the colourer. No node has a colour yet.
  explicit GreedyColorer(const Adjacency& adjacency);

  /// Gives the node the smallest colour that no neighbour has.
  void color(Index node);

  /// Gives the node this colour, or `kUncolored`.
  void set(Index node, Index color);

  Index color_of(Index node) const { return coloring_.color[node]; }
  Coloring take() { return std::move(coloring_); }

 private:
  const Adjacency& adjacency_;
  Coloring coloring_;
  std::vector<std::size_t> taken_in_;  ///< colour -> the last step with a neighbour of this colour
  std::size_t step_ = 0;
};

/// Jones-Plassmann-Luby as in the paper's section 4 (Naumov et al. 2015): in each round the nodes
/// whose hash is larger than those of all uncoloured neighbours get the round's number as colour.
/// Throws Cancelled if `progress` asks for it.
Coloring luby_coloring(const Adjacency& adjacency, std::uint32_t seed = 0,
                       const Progress& progress = {});

/// Nodes in the order of their numbers get the smallest colour that no neighbour has: fewer colours
/// than `luby_coloring`, at most the largest degree plus one.
Coloring greedy_coloring(const Adjacency& adjacency);

}  // namespace brindle
