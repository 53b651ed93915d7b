#include "brindle/phases/node_order.h"

#include "brindle/base/parallel.h"

namespace brindle {

BreadthFirstWalk::BreadthFirstWalk(const Adjacency& adjacency)
    : adjacency_(adjacency), seen_(adjacency.node_count()) {
  order_.reserve(adjacency.node_count());
}

void BreadthFirstWalk::visit(Index node) {
  if (seen_[node]) return;
  seen_[node] = 1;
  order_.push_back(node);
}

void BreadthFirstWalk::step() {
  while (next_ == order_.size()) visit(start_++);
  for (const Index neighbor : adjacency_.of(order_[next_++])) visit(neighbor);
}

std::vector<Index> breadth_first_order(const Adjacency& adjacency, const Progress& progress) {
  BreadthFirstWalk walk(adjacency);
  reported_for(adjacency.node_count(), progress, [&](std::size_t) { walk.step(); });
  return walk.take();
}

}  // namespace brindle
