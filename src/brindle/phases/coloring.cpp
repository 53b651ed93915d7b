#include "brindle/phases/coloring.h"

#include <algorithm>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/random.h"
#include "brindle/base/standard.h"

namespace brindle {

Coloring luby_coloring(const Adjacency& adjacency, std::uint32_t seed, const Progress& progress) {
  const std::size_t nodes = adjacency.node_count();
  std::vector<Index> color(nodes, kUncolored);
  // Hashed twice, because the random start is hashed once. If the order followed the start, early
  // nodes would draw all others towards the same phases. Ties go to the larger number.
  const auto priority = [seed](Index node) {
    return std::pair(jenkins_hash(jenkins_hash(node + seed)), node);
  };

  std::vector<Index> remaining(nodes);
  for (Index node = 0; node < nodes; ++node) remaining[node] = node;
  std::vector<std::uint8_t> chosen(nodes);
  Index round = 0;
  for (; !remaining.empty(); ++round) {
    progress.tick();
    parallel_for(remaining.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        const Index node = remaining[r];
        chosen[node] = ranges::all_of(adjacency.of(node), [&](Index neighbor) {
          return color[neighbor] != kUncolored || priority(neighbor) < priority(node);
        });
      }
    });
    std::erase_if(remaining, [&](Index node) {
      if (chosen[node]) color[node] = round;
      return chosen[node] != 0;
    });
  }
  return {std::move(color), round};
}

GreedyColorer::GreedyColorer(const Adjacency& adjacency)
    : adjacency_(adjacency), coloring_{std::vector<Index>(adjacency.node_count(), kUncolored), 0} {}

void GreedyColorer::color(Index node) {
  ++step_;
  for (const Index neighbor : adjacency_.of(node)) {
    const Index color = coloring_.color[neighbor];
    if (color != kUncolored) taken_in_[color] = step_;
  }
  Index color = 0;
  while (color < coloring_.color_count && taken_in_[color] == step_) ++color;
  set(node, color);
}

void GreedyColorer::set(Index node, Index color) {
  coloring_.color[node] = color;
  if (color == kUncolored || color < coloring_.color_count) return;
  coloring_.color_count = color + 1;
  taken_in_.resize(coloring_.color_count);
}

Coloring greedy_coloring(const Adjacency& adjacency) {
  GreedyColorer colorer(adjacency);
  for (Index node = 0; node < adjacency.node_count(); ++node) colorer.color(node);
  return colorer.take();
}

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
