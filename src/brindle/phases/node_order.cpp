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
  for (std::size_t n = 0; n < adjacency.node_count(); ++n) {
    if (n % kReportSlice == 0) progress.tick();
    walk.step();
  }
  return walk.take();
}

}  // namespace brindle
