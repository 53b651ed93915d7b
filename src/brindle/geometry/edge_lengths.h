/// Sizes that floats can work with.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/types.h"

namespace brindle {

/// Squares of areas of what is smaller or larger leave the range of float.
inline constexpr double kShortestEdges = 1e-10;
inline constexpr double kLongestEdges = 1e9;

/// The lengths of edges together, each counted from both ends.
struct EdgeLengths {
  double sum = 0;
  std::size_t count = 0;

  EdgeLengths operator+(const EdgeLengths& other) const {
    return {sum + other.sum, count + other.count};
  }
};

/// Of the edges to the neighbours of every vertex that has a row in `neighborhood`.
EdgeLengths edge_lengths(std::span<const Vec3> positions, const Adjacency& neighborhood);

/// Throws Error, with the remedy, unless edges are between kShortestEdges and kLongestEdges long on
/// average, or all have no length, or there are none.
void check_edge_lengths(const EdgeLengths& lengths);

}  // namespace brindle
