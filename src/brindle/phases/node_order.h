/// An order of nodes in which neighbours stand close together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// Breadth-first from the first node of every component: neighbours are at most two fronts apart,
/// whatever order the nodes had before.
class BreadthFirstWalk {
 public:
  explicit BreadthFirstWalk(const Adjacency& adjacency);

  /// To the next node, as often as there are nodes.
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

/// All steps of such a walk.
std::vector<Index> breadth_first_order(const Adjacency& adjacency, const Progress& progress = {});

}  // namespace brindle
