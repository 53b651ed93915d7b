/// Coarse levels that rank 0 holds alone.
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

/// Nodes are ordered by rank. All functions are collective.
class GatheredLevels {
 public:
  /// Gathers connectivity and couplings of a level, and builds the coarser ones. Throws Cancelled
  /// on all ranks if one rank's `progress` does.
  GatheredLevels(Communicator& ranks, const RankGraph& graph, const Level& level,
                 const Progress& progress);

  /// Gathers the couplings again, and recomputes what depends on them.
  void renew(Communicator& ranks, const Level& level);

  /// Rank 0 descends from the coarsest level; afterwards the level has the phases of its own nodes.
  void descend(Communicator& ranks, SweepPlan plan, Level& level);

  /// Gathers couplings, with the level's phases as gauges of the finer ones (`run_cycles`), and
  /// descends.
  void correct(Communicator& ranks, SweepPlan plan, Level& level);

 private:
  void lay_out(Communicator& ranks, const RankGraph& graph);
  void add_entries(std::span<const Index> degrees, std::span<const Index> neighbors);
  void pack(const Level& level);
  void load(std::span<const std::byte> packed, int rank,
            std::vector<ReflectingCoupling>& reflecting);
  void gather_couplings(Communicator& ranks, const Level& level);
  void scatter(Level& level);

  std::shared_ptr<const Adjacency> adjacency_;  ///< of own nodes
  PartsOnFirst nodes_, edges_;
  std::vector<std::byte> packed_;
  std::vector<Complex> own_z_;
  // On rank 0 only.
  Hierarchy hierarchy_;
  std::vector<Index> entry_of_;  ///< of each edge in the first level's layout
  std::vector<Complex> z_;
};

}  // namespace brindle
