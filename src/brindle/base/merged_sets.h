/// Sets of numbers that grow together (union-find).
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "brindle/types.h"

namespace brindle {

/// At first every number from 0 is a set of its own. A set's least member stands for it.
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

}  // namespace brindle
