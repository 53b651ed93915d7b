/// Searches in graphs: sets that grow together, and shortest ways.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "brindle/types.h"

namespace brindle {

/// Disjoint sets (union-find). At first every number from 0 is a set of its own. A set's least
/// member stands for it.
class MergedSets {
 public:
  explicit MergedSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// The least member of the set that an item belongs to.
  Index of(Index item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  /// Whether they were in two sets before.
  bool merge(Index a, Index b) {
    const Index first = of(a), second = of(b);
    parent_[std::max(first, second)] = std::min(first, second);
    return first != second;
  }

 private:
  std::vector<Index> parent_;
};

/// Shortest ways from some nodes of a graph (Dijkstra 1959), step by step: `offer` the nodes to
/// start from, then take the `next` node and offer its neighbours, until there is none.
template <class Distance>
class ShortestWays {
 public:
  explicit ShortestWays(std::size_t nodes) : distance_(nodes, kNever) {}

  /// Whether this way to the node is shorter than those known so far.
  bool offer(Index node, Distance distance) {
    if (distance >= distance_[node]) return false;
    if (distance_[node] == kNever) reached_.push_back(node);
    distance_[node] = distance;
    waiting_.emplace(distance, node);
    return true;
  }

  /// The nearest node that was not taken yet; of equally near ones the one of lowest number.
  std::optional<std::pair<Distance, Index>> next() {
    while (!waiting_.empty()) {
      const auto nearest = waiting_.top();
      waiting_.pop();
      if (nearest.first <= distance_[nearest.second]) return nearest;
    }
    return std::nullopt;
  }

  /// Infinite where no way has led so far.
  Distance distance(Index node) const { return distance_[node]; }

  /// For another search in the same graph; takes as long as the last one reached nodes.
  void clear() {
    waiting_ = {};
    for (const Index node : reached_) distance_[node] = kNever;
    reached_.clear();
  }

 private:
  static constexpr Distance kNever = std::numeric_limits<Distance>::infinity();
  using Entry = std::pair<Distance, Index>;

  std::vector<Distance> distance_;
  std::vector<Index> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;
};

}  // namespace brindle
