/// An order of nodes in which neighbours are close together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

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
