/// Graph colouring: nodes of one colour are not neighbours, so they can be updated in parallel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// A colour per node.
struct Coloring {
  std::vector<Index> color;  ///< one per node, below `color_count`; every colour is used
  Index color_count = 0;
};

inline constexpr Index kUncolored = ~Index{0};

/// Colours nodes one by one; some may be coloured beforehand.
class GreedyColorer {
 public:
  /// `adjacency` must outlive the colourer. All nodes start uncoloured.
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

/// Jones-Plassmann-Luby as in the paper's section 4 (Naumov et al. 2015). In each round, nodes with
/// a larger hash than all uncoloured neighbours get the round's number as their colour. Throws
/// Cancelled if `progress` cancels.
Coloring luby_coloring(const Adjacency& adjacency, std::uint32_t seed = 0,
                       const Progress& progress = {});

/// Each node, in the order of numbers, gets the smallest colour that no neighbour has. Uses fewer
/// colours than `luby_coloring`, at most the largest degree plus one.
Coloring greedy_coloring(const Adjacency& adjacency);

// An order of nodes in which neighbours are close together.

/// Breadth-first order from the first node of each component: neighbours are at most two fronts
/// apart, however the nodes are numbered.
class BreadthFirstWalk {
 public:
  explicit BreadthFirstWalk(const Adjacency& adjacency);

  /// Visits the next node; called once per node.
  void step();
  std::vector<Index> take() { return std::move(order_); }

 private:
  void visit(Index node);

  const Adjacency& adjacency_;
  std::vector<Index> order_;
  std::vector<std::uint8_t> seen_;
  std::size_t next_ = 0;
  Index start_ = 0;
};

/// The order of a complete walk. Throws Cancelled if `progress` cancels.
std::vector<Index> breadth_first_order(const Adjacency& adjacency, const Progress& progress = {});

}  // namespace brindle
