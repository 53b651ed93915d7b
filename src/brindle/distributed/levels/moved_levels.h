/// Planned levels, whose nodes stand on other ranks than where their couplings are set.
#pragma once

#include <vector>

#include "brindle/distributed/levels/level_plan.h"
#include "brindle/distributed/levels/rank_hierarchy.h"

namespace brindle {

/// All functions must be called by all ranks; `ranks` must live as long.
class MovedLevels {
 public:
  /// `source` has the nodes where their couplings are set; the last planned level is gathered as
  /// `rest` says.
  MovedLevels(Communicator& ranks, const RankGraph& source, LevelPlan plan, Gathering rest);

  RankHierarchy& levels() { return levels_; }
  const RankHierarchy& levels() const { return levels_; }

  /// Makes couplings and anchors of the finest level those that the source has.
  void load(const Level& source);

  /// Makes phases of the finest level those that the source has.
  void take_phases(const Level& source);

  /// Gives the source's own nodes their phases.
  void bring_back(Level& source);

 private:
  MovedLevels(Communicator& ranks, const RankGraph& source, const LevelPlan& plan,
              PlannedGraph planned, Gathering rest);
  void take_places(const LevelPlan& plan, const std::vector<Index>& neighbor);

  Communicator& ranks_;
  RankHierarchy levels_;
  // By rank.
  std::vector<std::vector<Index>> own_;   ///< own nodes whose couplings it sets
  std::vector<RowPlaces> places_;         ///< where these stand
  std::vector<std::vector<Index>> sent_;  ///< nodes of the source that it has here
  std::vector<RowPacker> packers_;        ///< of these
  std::vector<std::vector<std::byte>> packed_;
};

}  // namespace brindle
