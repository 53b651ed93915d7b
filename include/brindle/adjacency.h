/// Who is next to whom: the one graph structure that all rooms share.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A symmetric graph in compressed rows. The neighbours of node i are
/// `neighbors[offsets[i]] .. neighbors[offsets[i + 1] - 1]`, in ascending order, without i itself
/// and without repetition; j is a neighbour of i exactly if i is one of j. An entry of `neighbors`
/// is also the number of the directed edge that it stands for: neighbour -> i.
struct Adjacency {
  std::vector<Index> offsets{0};  ///< nodes + 1 entries
  std::vector<Index> neighbors;   ///< one entry a directed edge

  std::size_t node_count() const { return offsets.size() - 1; }
  std::size_t directed_edge_count() const { return neighbors.size(); }
  std::size_t edge_count() const { return neighbors.size() / 2; }

  std::span<const Index> of(Index node) const {
    return std::span(neighbors).subspan(offsets[node], offsets[node + 1] - offsets[node]);
  }
};

}  // namespace brindle
