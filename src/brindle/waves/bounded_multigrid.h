/// Least squares between bounds, by multigrid.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/progress.h"
#include "brindle/waves/row_levels.h"
#include "brindle/waves/row_peers.h"

namespace brindle {

/// Minimises x'Ax - 2 b'x over lower <= x <= upper, A symmetric and positive semidefinite with the
/// pattern of `RowLevels`. A cycle is a sweep of projected Gauss-Seidel, a correction by the
/// coarser levels of the nodes that no bound holds, projected back and as long as the energy asks
/// for, and a sweep the other way round (truncated multigrid: Kornhuber 1994, Gräser and Kornhuber
/// 2009). Blocks of rows are relaxed at the same time, each with the others' last values and the
/// diagonal larger by what they share (Baker et al. 2011), so that sweeps never raise the energy
/// and the result is the same for every number of threads. Nothing is allocated after construction.
/// Where `progress` throws, `x` is somewhere on its way.
///
/// With peers, who must live as long, it is one multigrid over all processes: others' nodes have
/// values beside the own ones, come after them, and are what the others say at the end of a sweep.
class BoundedMultigrid {
 public:
  explicit BoundedMultigrid(std::shared_ptr<const RowLevels> levels, RowPeers* peers = nullptr);

  // The problem, by place (`RowLevels::place_of`). Lower bounds are not above 1, upper ones not
  // below. `x` and bounds have others' nodes, too.
  std::span<float> values() { return levels_[0].values; }  ///< of the matrix, by entry
  std::span<float> diagonal() { return levels_[0].diagonal; }
  std::span<float> right() { return levels_[0].right; }  ///< b
  std::span<float> lower() { return levels_[0].lower; }
  std::span<float> upper() { return levels_[0].upper; }
  std::span<float> x() { return levels_[0].x; }  ///< start and result

  /// After the problem has changed.
  void prepare();

  /// A start for `x`: from the coarsest level down, each between the bounds that its nodes share.
  void start(const Progress& progress = {});

  struct Measure {
    double energy = 0;              ///< x'Ax - 2 b'x
    double projected_gradient = 0;  ///< length of b - Ax, less what points out of the bounds
  };

  /// One cycle. Says how far things were after its first sweep.
  Measure cycle(const Progress& progress = {});

  /// How far things are.
  Measure measure();

  // For the coarser levels of another one.
  void start_as_coarser();                ///< `start`, with sweeps at the end
  void prepare_without_bounds();          ///< after the matrix has changed
  void solve_without_bounds(int visits);  ///< so many cycles from zero

 private:
  struct Level {
    std::vector<float> values, diagonal, right, x;
    std::vector<float> inverse;  ///< what a residual is multiplied by
    std::vector<float> last;     ///< x before a sweep, where there are several blocks
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
  RowPeers* peers_;
  std::vector<Level> levels_;
  std::vector<float> residual_, step_;
  std::vector<float> last_x_, last_residual_;  ///< of the cycle before, after its first sweep
  std::vector<float> free_;                    ///< 0 where a bound holds a node, otherwise 1
  double nodes_of_all_ = 0;
  double changed_ = 0;  ///< nodes held or let go since the coarser levels were summed
  bool summed_ = false;
  double last_energy_ = 0;
  double longest_step_ = 0;
  bool has_momentum_ = false;
};

}  // namespace brindle
