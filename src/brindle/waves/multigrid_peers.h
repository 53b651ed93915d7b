/// The interface of a multigrid solver to other processes that have rows of the same matrix.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/waves/row_levels.h"

namespace brindle {

/// Entries of a matrix.
struct RowMatrix {
  std::span<const float> values;  ///< by entry
  std::span<const float> diagonal;
};

/// A x = b, with bounds on x unless they are empty.
struct RowProblem {
  std::span<const float> right, lower, upper;
};

/// All processes must call all functions, in the same order, with their own parts. One process
/// holds the complete coarsest level, and still coarser ones.
class MultigridPeers {
 public:
  virtual ~MultigridPeers() = default;

  /// The levels of the distributed graph. Called first, and again for another graph.
  virtual RowLevels make_levels(const Adjacency& adjacency, std::span<const float> strengths) = 0;

  /// Whether this is the first process with nodes.
  virtual bool has_first_node() const = 0;

  /// Blocks of rows whose values other processes need, and all other blocks.
  virtual std::span<const Index> border_blocks(std::size_t level) const = 0;
  virtual std::span<const Index> inner_blocks(std::size_t level) const = 0;

  /// Sends values of own nodes to processes that need them; after `finish`, ghosts have their
  /// values. In between, border blocks must not change and ghosts must not be read.
  virtual void start(std::size_t level, std::span<float> by_place) = 0;
  virtual void finish() = 0;

  /// Replaces values by their sums over all processes, added in the same order in every run.
  virtual void sum(std::span<double> values) = 0;

  /// The least over all processes.
  virtual double least(double value) = 0;

  /// Replaces the matrix of the coarsest level.
  virtual void set_coarsest(const RowMatrix& matrix) = 0;

  /// The solution on the coarsest level, ghosts included, by `visits` cycles from 0 without bounds.
  virtual void solve_coarsest(std::span<const float> right, int visits, std::span<float> x) = 0;

  /// The same with bounds, starting from 1 on the coarsest level of that process.
  virtual void start_coarsest(const RowProblem& problem, std::span<float> x) = 0;
};

/// The sum over all processes; `sums` itself without peers.
template <class Sums>
Sums over_all(MultigridPeers* peers, Sums sums) {
  if (peers == nullptr) return sums;
  auto numbers = sums.numbers();
  peers->sum(numbers);
  return Sums::of(numbers);
}

}  // namespace brindle
