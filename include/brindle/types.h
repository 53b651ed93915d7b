/// The scalar, vector, index and graph types that every module shares.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// The number of a vertex, node, edge or triangle.
using Index = std::uint32_t;

/// A point or direction in space.
using Vec3 = Eigen::Vector3f;

/// A phase as the complex number exp(i Phi), or a coupling between two phases.
using Complex = std::complex<float>;

/// Neighbours of nodes: a symmetric graph in compressed rows. The neighbours of node i are
/// `neighbors[offsets[i]] .. neighbors[offsets[i + 1] - 1]`, in ascending order, without i itself
/// and without repetition; j is a neighbour of i exactly if i is one of j. The index of an entry of
/// `neighbors` is also the number of the directed edge: neighbour -> i.
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
