/// What owners of vertices tell the other ranks that have them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <brindle/types.h>

#include "ranks.h"

namespace brindle::paraview {

/// Collective, all of it. Vertices are those of this rank's piece.
class OwnerExchange {
 public:
  /// Vertices of several ranks are one if they have one number; exactly one of these ranks owns it.
  OwnerExchange(const Ranks& ranks, std::span<const std::uint64_t> numbers,
                std::span<const std::uint8_t> is_own);

  /// Gives vertices that other ranks own the values that they have there.
  template <class T>
  void from_owners(std::span<T> by_vertex) const {
    const auto values = ranks_.swap_lists(values_at(own_, by_vertex));
    for (std::size_t r = 0; r < values.size(); ++r) {
      for (std::size_t i = 0; i < values[r].size(); ++i) by_vertex[others_[r][i]] = values[r][i];
    }
  }

  /// Adds to own values those of all other ranks, in the order of ranks, and gives all the sums.
  template <class T>
  void sum(std::span<T> by_vertex) const {
    const auto values = ranks_.swap_lists(values_at(others_, by_vertex));
    for (std::size_t r = 0; r < values.size(); ++r) {
      for (std::size_t i = 0; i < values[r].size(); ++i) by_vertex[own_[r][i]] += values[r][i];
    }
    from_owners(by_vertex);
  }

 private:
  using Lists = std::vector<std::vector<Index>>;

  template <class T>
  static auto values_at(const Lists& lists, std::span<T> by_vertex) {
    std::vector<std::vector<T>> values(lists.size());
    for (std::size_t r = 0; r < lists.size(); ++r) {
      for (const Index v : lists[r]) values[r].push_back(by_vertex[v]);
    }
    return values;
  }

  Ranks ranks_;
  Lists own_;     ///< per rank: own vertices that it has, too
  Lists others_;  ///< per rank: vertices that it owns
};

}  // namespace brindle::paraview
