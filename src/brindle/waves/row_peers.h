/// The other processes that have rows of a matrix, for a solver that knows nothing of messages.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/waves/row_levels.h"

namespace brindle {

/// What a matrix has at some nodes, or all.
struct RowMatrix {
  std::span<const float> values;  ///< by entry
  std::span<const float> diagonal;
};

/// What x is wanted for: A x = b, between bounds where there are any.
struct RowProblem {
  std::span<const float> right, lower, upper;
};

/// All functions must be called by all processes, in the same order, with their own parts. The
/// coarsest level is not theirs: one process has all of it, and coarser ones.
class RowPeers {
 public:
  virtual ~RowPeers() = default;

  /// Levels of the graph that all processes hold together. Called first, and again for others.
  virtual RowLevels make_levels(const Adjacency& adjacency, std::span<const float> strengths) = 0;

  /// Whether no process before this one has nodes, and this one has.
  virtual bool has_first_node() const = 0;

  /// Blocks of rows of which others need values, and the rest.
  virtual std::span<const Index> border_blocks(std::size_t level) const = 0;
  virtual std::span<const Index> inner_blocks(std::size_t level) const = 0;

  /// Sends values of own nodes to those who need them; after `finish` others' nodes have theirs. In
  /// between, what is at the border stays, and others' nodes are not read.
  virtual void start(std::size_t level, std::span<float> by_place) = 0;
  virtual void finish() = 0;

  /// Replaces values by their sums over all processes, in the same order in every run.
  virtual void sum(std::span<double> values) = 0;

  /// The least over all processes.
  virtual double least(double value) = 0;

  /// The coarsest level has a new matrix.
  virtual void set_coarsest(const RowMatrix& matrix) = 0;

  /// Its solution by so many cycles from zero, without bounds, others' nodes included.
  virtual void solve_coarsest(std::span<const float> right, int visits, std::span<float> x) = 0;

  /// The same between bounds, from 1 on the coarsest level of all.
  virtual void start_coarsest(const RowProblem& problem, std::span<float> x) = 0;
};

/// The sum over all processes, if there are others.
template <class Sums>
Sums over_all(RowPeers* peers, Sums sums) {
  if (peers == nullptr) return sums;
  auto numbers = sums.numbers();
  peers->sum(numbers);
  return Sums::of(numbers);
}

}  // namespace brindle
