/// Graph searches: union-find and shortest paths.
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

/// Disjoint sets (union-find). Initially every number is a set of its own. The least member
/// represents a set.
class MergedSets {
 public:
  explicit MergedSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// The least member of an item's set.
  Index of(Index item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  /// Merges two sets. Returns whether they were different.
  bool merge(Index a, Index b) {
    const Index first = of(a), second = of(b);
    parent_[std::max(first, second)] = std::min(first, second);
    return first != second;
  }

 private:
  std::vector<Index> parent_;
};

/// Shortest paths in a graph (Dijkstra 1959), step by step: `offer` the start nodes, then take the
/// `next` node and offer its neighbours, until none is left.
template <class Distance>
class ShortestWays {
 public:
  explicit ShortestWays(std::size_t nodes) : distance_(nodes, kNever) {}

  /// Offers a path to the node. Returns whether it is the shortest so far.
  bool offer(Index node, Distance distance) {
    if (distance >= distance_[node]) return false;
    if (distance_[node] == kNever) reached_.push_back(node);
    distance_[node] = distance;
    waiting_.emplace(distance, node);
    return true;
  }

  /// The nearest node not taken yet; ties go to the lowest number.
  std::optional<std::pair<Distance, Index>> next() {
    while (!waiting_.empty()) {
      const auto nearest = waiting_.top();
      waiting_.pop();
      if (nearest.first <= distance_[nearest.second]) return nearest;
    }
    return std::nullopt;
  }

  /// Infinite for nodes not reached so far.
  Distance distance(Index node) const { return distance_[node]; }

  /// Resets for another search; the time is proportional to the nodes reached.
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
