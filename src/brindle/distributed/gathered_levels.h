/// A level that has become small, and all coarser ones, on rank 0 alone.
#pragma once

#include <span>
#include <vector>

#include "brindle/distributed/rank_graph.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/progress.h"

namespace brindle {

/// All functions must be called by all ranks.
class GatheredLevels {
 public:
  /// Gathers the connectivity and the couplings of a level, and builds the coarser ones.
  /// `is_finest` tells whether no level is finer. Throws Cancelled on all ranks if `progress` asks
  /// rank 0 for it.
  GatheredLevels(Communicator& ranks, const RankGraph& graph, const Level& level, bool is_finest,
                 const Progress& progress);

  /// Gathers the couplings again, and renews what follows from them.
  void renew(Communicator& ranks, const RankGraph& graph, const Level& level);

  /// Solves the gathered levels from the coarsest one on; the level has its own nodes' phases
  /// afterwards.
  void descend(Communicator& ranks, const RankGraph& graph, int sweeps, Level& level);

  /// Gathers couplings in which the level's phases are the gauges of finer ones (`run_cycles`), or,
  /// of the finest level, starts from the phases that `descend` has found, and does the same.
  void correct(Communicator& ranks, const RankGraph& graph, int sweeps, Level& level);

 private:
  void gather_graph(Communicator& ranks, const RankGraph& graph);
  void gather_couplings(Communicator& ranks, const RankGraph& graph, const Level& level);
  void load(std::span<const std::vector<std::byte>> parts);
  void scatter(Communicator& ranks, const RankGraph& graph, Level& level);

  bool is_finest_;
  // On rank 0 alone.
  std::vector<Index> first_node_;  ///< of every rank, and the end
  std::vector<std::size_t> first_edge_;
  std::vector<Index> entry_of_edge_;  ///< the ranks' directed edges, rank by rank as they have them
  Hierarchy hierarchy_;
  std::vector<Complex> z_;  ///< by node
  // On all.
  std::vector<std::byte> packed_;
  std::vector<Complex> own_z_;
};

}  // namespace brindle
