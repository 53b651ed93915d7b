/// Exchanges values of shared vertices between ranks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <brindle/types.h>

#include "ranks.h"

namespace brindle::paraview {

/// All functions are collective. Vertices are those of this rank's partition.
class OwnerExchange {
 public:
  /// Vertices with one number on several ranks are one; exactly one rank owns it.
  OwnerExchange(const Ranks& ranks, std::span<const std::uint64_t> numbers,
                std::span<const std::uint8_t> is_own);

  /// Sets vertices of other owners to the owners' values.
  template <class T>
  void from_owners(std::span<T> by_vertex) const {
    const auto values = ranks_.swap_lists(values_at(own_, by_vertex));
    for (std::size_t r = 0; r < values.size(); ++r) {
      for (std::size_t i = 0; i < values[r].size(); ++i) by_vertex[others_[r][i]] = values[r][i];
    }
  }

  /// Sums the values of all ranks at each vertex, in rank order, on all ranks.
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
  Lists own_;     ///< per rank: own vertices that it shares
  Lists others_;  ///< per rank: vertices that it owns
};

}  // namespace brindle::paraview
