/// A level that has become small, and all coarser ones, on rank 0 alone.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "brindle/distributed/levels/coupling_rows.h"
#include "brindle/distributed/levels/gathered_graph.h"
#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/progress.h"

namespace brindle {

/// How nodes are gathered. All but `is_finest` are of rank 0 alone.
struct Gathering {
  bool is_finest = false;        ///< whether no level is finer
  std::vector<Index> number_of;  ///< what the ranks' nodes, rank by rank, are numbered; empty: so
  Hierarchy hierarchy;           ///< of nodes with these numbers, if it is there already
};

/// All functions must be called by all ranks.
class GatheredLevels {
 public:
  /// Gathers the connectivity and the couplings of a level, and builds the coarser ones. Throws
  /// Cancelled on all ranks if `progress` asks rank 0 for it.
  GatheredLevels(Communicator& ranks, const RankGraph& graph, const Level& level,
                 Gathering gathering, const Progress& progress);

  /// Gathers the couplings again, and renews what follows from them.
  void renew(Communicator& ranks, const Level& level);

  /// Rank 0 solves the gathered levels as `solve` does, a descent from the coarsest one on; the
  /// level has its own nodes' phases afterwards.
  void descend(Communicator& ranks, const RankGraph& graph, Level& level,
               const std::function<void(Hierarchy&)>& solve);

  /// Makes rank 0's phases of the first level those of the level's own nodes.
  void take_phases(Communicator& ranks, const RankGraph& graph, const Level& level);

  /// Gathers couplings in which the level's phases are the gauges of finer ones (`run_cycles`), or,
  /// of the finest level, starts from the phases that `descend` has found or `take_phases` brought,
  /// and does the same.
  void correct(Communicator& ranks, const RankGraph& graph, SweepPlan plan, Level& level);

  /// On rank 0: the levels, and for every rank where its rows stand in the first one.
  Hierarchy& hierarchy() { return hierarchy_; }
  std::span<const RowPlaces> places() const { return places_; }

 private:
  void lay_out();
  void gather_couplings(Communicator& ranks, const Level& level);
  void scatter(Communicator& ranks, const RankGraph& graph, Level& level);

  /// Of a node of the gathered graph, rank by rank.
  Index slot_of(Index node) const {
    return hierarchy_.levels[0].layout().slot_of[graph_.number_of[node]];
  }

  bool is_finest_;
  GatheredGraph graph_;
  // On rank 0 alone.
  Hierarchy hierarchy_;
  std::vector<RowPlaces> places_;
  std::vector<Complex> z_;  ///< rank by rank
  // On all.
  RowPacker packer_;
  std::vector<std::byte> packed_;
  std::vector<Complex> own_z_;
};

}  // namespace brindle
