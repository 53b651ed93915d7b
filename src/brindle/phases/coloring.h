/// Graph colouring: nodes of one colour are no neighbours and can be updated at the same time.
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

/// Colours nodes one after the other, some of which may have colours already.
class GreedyColorer {
 public:
  /// `adjacency` must outlive the colourer. Nothing has a colour yet.
  explicit GreedyColorer(const Adjacency& adjacency);

  /// Gives the node the smallest colour that no neighbour has yet.
  void color(Index node);

  /// Gives the node this colour, or none.
  void set(Index node, Index color);

  Index color_of(Index node) const { return coloring_.color[node]; }
  Coloring take() { return std::move(coloring_); }

 private:
  const Adjacency& adjacency_;
  Coloring coloring_;
  std::vector<std::size_t> taken_in_;  ///< the last step that saw a neighbour of this colour
  std::size_t step_ = 0;
};

/// Jones-Plassmann-Luby as in the paper's section 4 (Naumov et al. 2015): in every round the nodes
/// whose hash is larger than that of all uncoloured neighbours get the round's number as colour.
Coloring luby_coloring(const Adjacency& adjacency, std::uint32_t seed = 0,
                       const Progress& progress = {});

/// The smallest colour that no neighbour has yet, in the order of node numbers. Fewer colours than
/// `luby_coloring`: at most the largest degree plus one.
Coloring greedy_coloring(const Adjacency& adjacency);

}  // namespace brindle
