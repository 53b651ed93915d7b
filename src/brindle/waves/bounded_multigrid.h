/// Least squares with bounds, by multigrid.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "brindle/progress.h"
#include "brindle/waves/row_levels.h"

namespace brindle {

// The interface of a multigrid solver to other processes that have rows of the same matrix.

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

/// Minimises x'Ax - 2 b'x over lower <= x <= upper, for A symmetric and positive semidefinite with
/// the pattern of `RowLevels`. Cycles are truncated multigrid (Kornhuber 1994, Gräser and Kornhuber
/// 2009). A cycle starts with a sweep of projected Gauss-Seidel. Then the coarser levels correct
/// all nodes that are not at a bound; the correction gets the length of least energy and is
/// projected. A sweep in reverse order ends the cycle. Blocks of rows are relaxed in parallel, each
/// with the others' last values and a diagonal enlarged by their common entries (Baker et al.
/// 2011). So sweeps never raise the energy, and results do not depend on the number of threads.
/// Nothing is allocated after construction. If `progress` throws, `x` is an intermediate value.
///
/// With `peers`, which must outlive this, it is one multigrid over all processes. Nodes of other
/// processes (ghosts) come after own ones; their owners send their values at the end of a sweep.
class BoundedMultigrid {
 public:
  explicit BoundedMultigrid(std::shared_ptr<const RowLevels> levels,
                            MultigridPeers* peers = nullptr);

  // The problem, by place (`RowLevels::place_of`). Lower bounds are at most 1, upper ones at least
  // 1. `x` and bounds include ghosts.
  std::span<float> values() { return levels_[0].values; }  ///< of the matrix, by entry
  std::span<float> diagonal() { return levels_[0].diagonal; }
  std::span<float> right() { return levels_[0].right; }  ///< b
  std::span<float> lower() { return levels_[0].lower; }
  std::span<float> upper() { return levels_[0].upper; }
  std::span<float> x() { return levels_[0].x; }  ///< start and result

  /// Must be called after the problem has changed.
  void prepare();

  /// Sets `x` to a start, computed from the coarsest level down; each level stays within the common
  /// bounds of its nodes.
  void start(const Progress& progress = {});

  struct Measure {
    double energy = 0;              ///< x'Ax - 2 b'x
    double projected_gradient = 0;  ///< length of b - Ax without parts that point out of the bounds
  };

  /// Runs one cycle; returns the measure after its first sweep.
  Measure cycle(const Progress& progress = {});

  /// The measure of `x`.
  Measure measure();

  // For use as the coarser levels of another multigrid.
  void start_as_coarser();                ///< `start`, with sweeps at the end
  void prepare_without_bounds();          ///< after the matrix has changed
  void solve_without_bounds(int visits);  ///< `visits` cycles from zero

 private:
  struct Level {
    std::vector<float> values, diagonal, right, x;
    std::vector<float> inverse;  ///< factors of residuals
    std::vector<float> last;     ///< x before a sweep, if there are several blocks
    std::vector<float> lower, upper;
  };
  void weigh(std::size_t level);
  bool is_coarsest(std::size_t level) const { return level + 1 == levels_.size(); }
  void sum(std::size_t level);
  void sum_all(const Progress& progress = {});
  template <bool kBounded>
  void relax_block(std::size_t level, std::size_t block, bool forward);
  template <bool kBounded>
  void relax_blocks(std::size_t level, std::span<const Index> blocks, bool forward);
  template <bool kBounded>
  void sweep(std::size_t level, bool forward);
  void exchange(std::size_t level, std::span<float> by_place);
  template <class Residual>
  void restrict_sums(std::size_t level, const Residual& residual);
  void restrict_free_residual();
  void restrict_residual(std::size_t level);
  void restrict_bounds(std::size_t level);
  void correct(std::size_t level);
  void start_with(int finest_sweeps, const Progress& progress = {});
  void visit(std::size_t level, int visits);
  void descend(std::size_t level);
  void correct_finest(const Progress& progress);
  void step();

  std::shared_ptr<const RowLevels> rows_;
  MultigridPeers* peers_;
  std::vector<Level> levels_;
  std::vector<float> residual_, step_;
  std::vector<float> last_x_, last_residual_;  ///< of the previous cycle, after its first sweep
  std::vector<float> free_;                    ///< 0 for nodes held by a bound, otherwise 1
  double nodes_of_all_ = 0;
  double changed_ = 0;  ///< changes of `free_` since the coarser levels were summed
  bool summed_ = false;
  double last_energy_ = 0;
  double longest_step_ = 0;
  bool has_momentum_ = false;
};

}  // namespace brindle
