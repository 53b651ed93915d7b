/// Rows that have become few, and all coarser ones, on rank 0 alone.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/distributed/halo.h"
#include "brindle/distributed/parts_on_first.h"
#include "brindle/types.h"
#include "brindle/waves/bounded_multigrid.h"
#include "brindle/waves/multigrid_peers.h"
#include "brindle/waves/row_levels.h"

namespace brindle {

/// All functions must be called by all ranks, with what they have of their own nodes.
class GatheredRows {
 public:
  /// Of the coarsest graph that all ranks hold, whose rows are those of `level`.
  GatheredRows(Communicator& ranks, const StrengthGraph& graph, const NodeHalo& halo,
               const RowLevel& level);

  void set(const RowMatrix& matrix);

  /// As the functions of the same names of MultigridPeers, for own nodes.
  void solve(std::span<const float> right, int visits, std::span<float> x);
  void start(const RowProblem& problem, std::span<float> x);

 private:
  void gather_graph(Communicator& ranks, const StrengthGraph& graph, const NodeHalo& halo,
                    const RowLevel& level);
  void find_entries(const Adjacency& adjacency);
  std::span<float> on_root(std::span<float> (BoundedMultigrid::*part)());
  void take_nodes(std::span<const float> own, std::span<float> by_place);
  void scatter(std::span<float> own);

  PartsOnFirst nodes_, entries_;
  // On rank 0 alone.
  std::shared_ptr<const RowLevels> levels_;
  std::unique_ptr<BoundedMultigrid> multigrid_;
  std::vector<Index> entry_of_;  ///< the ranks' entries, as they have them -> entry here
  std::vector<float> all_;       ///< what has come from all ranks, or goes to them
};

}  // namespace brindle
