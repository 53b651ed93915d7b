/// Coarse rows that rank 0 holds alone.
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

/// All functions are collective, with values of own nodes.
class GatheredRows {
 public:
  /// From the coarsest distributed graph, whose rows are those of `level`.
  GatheredRows(Communicator& ranks, const StrengthGraph& graph, const NodeHalo& halo,
               const RowLevel& level);

  void set(const RowMatrix& matrix);

  /// As the functions of the same names in MultigridPeers, for own nodes.
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
  // On rank 0 only.
  std::shared_ptr<const RowLevels> levels_;
  std::unique_ptr<BoundedMultigrid> multigrid_;
  std::vector<Index> entry_of_;  ///< maps the ranks' entries to entries here
  std::vector<float> all_;       ///< received from, or to be sent to, all ranks
};

}  // namespace brindle
