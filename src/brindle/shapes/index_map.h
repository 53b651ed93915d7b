/// A hash map in one block of memory, much faster to fill and free than node-based maps.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "brindle/types.h"

namespace brindle {

/// Open addressing with linear probing. Keys are never removed.
class IndexMap {
 public:
  /// Inserts the key with `number` unless it exists; returns its number and whether it is new. ~0
  /// is no valid key.
  std::pair<Index, bool> try_emplace(std::uint64_t key, Index number) {
    if (2 * (count_ + 1) > entries_.size()) grow();
    Entry& entry = place(key);
    if (entry.key == key) return {entry.number, false};
    entry = {key, number};
    ++count_;
    return {number, true};
  }

 private:
  static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};

  struct Entry {
    std::uint64_t key = kNoKey;
    Index number = 0;
  };

  Entry& place(std::uint64_t key) {
    // Fibonacci hashing: the upper bits of the product depend on all bits of the key.
    const std::size_t last = entries_.size() - 1;
    auto at = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> (64 - std::bit_width(last)));
    while (entries_[at].key != kNoKey && entries_[at].key != key) at = (at + 1) & last;
    return entries_[at];
  }

  void grow() {
    constexpr std::size_t kFewest = 1024;
    std::vector<Entry> before(entries_.empty() ? kFewest : 2 * entries_.size());
    before.swap(entries_);
    for (const Entry& entry : before) {
      if (entry.key != kNoKey) place(entry.key) = entry;
    }
  }

  std::vector<Entry> entries_;  // size is a power of two, at most half full
  std::size_t count_ = 0;
};

}  // namespace brindle
