/// A level that has become small, and all coarser ones, on rank 0 alone.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/distributed/parts_on_first.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/progress.h"

namespace brindle {

/// Nodes are those of rank 0, then those of rank 1, and so on. All functions must be called by all
/// ranks.
class GatheredLevels {
 public:
  /// Gathers the connectivity and the couplings of a level, and builds the coarser ones. Throws
  /// Cancelled on all ranks if the `progress` of one asks for it.
  GatheredLevels(Communicator& ranks, const RankGraph& graph, const Level& level,
                 const Progress& progress);

  /// Gathers the couplings again, and renews what follows from them.
  void renew(Communicator& ranks, const Level& level);

  /// Rank 0 descends from the coarsest level on; the level has its own nodes' phases afterwards.
  void descend(Communicator& ranks, SweepPlan plan, Level& level);

  /// Gathers couplings in which the level's phases are the gauges of finer ones (`run_cycles`), and
  /// does the same.
  void correct(Communicator& ranks, SweepPlan plan, Level& level);

 private:
  void lay_out(Communicator& ranks, const RankGraph& graph);
  void add_entries(std::span<const Index> degrees, std::span<const Index> neighbors);
  void pack(const Level& level);
  void load(std::span<const std::byte> packed, int rank,
            std::vector<ReflectingCoupling>& reflecting);
  void gather_couplings(Communicator& ranks, const Level& level);
  void scatter(Level& level);

  std::shared_ptr<const Adjacency> adjacency_;  ///< of this rank's nodes
  PartsOnFirst nodes_, edges_;
  std::vector<std::byte> packed_;
  std::vector<Complex> own_z_;
  // On rank 0 alone.
  Hierarchy hierarchy_;
  std::vector<Index> entry_of_;  ///< of every edge in the first level's layout
  std::vector<Complex> z_;
};

}  // namespace brindle
