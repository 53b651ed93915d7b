/// The multilevel solver of a graph over ranks, as frames and fields use it (docs/distributed.md).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/distributed/levels/moved_levels.h"
#include "brindle/distributed/levels/rank_hierarchy.h"
#include "brindle/distributed_stripes.h"

namespace brindle {

/// Which levels rank 0 has to do with, by their number of nodes on all ranks together.
struct HierarchyBounds {
  std::size_t gather_below = DistributedOptions().gather_below;  ///< it solves these
  std::size_t plan_below = DistributedOptions().plan_below;  ///< of a finest level: it plans all

  /// What rank 0 has as a whole anyway it plans, too.
  std::size_t planned_below() const { return std::max(gather_below, plan_below); }
};

/// Levels are grown within ranks (RankHierarchy), or, of small graphs, planned by rank 0 and moved
/// to where the plan has them. All functions but `finest` must be called by all ranks, and `ranks`
/// must live as long.
class DistributedHierarchy {
 public:
  /// The finest level alone. `ids` are the numbers of own nodes in the whole.
  DistributedHierarchy(Communicator& ranks, RankGraph graph, std::vector<std::uint64_t> ids,
                       HierarchyBounds bounds);

  /// As those of RankHierarchy.
  Level& finest() { return levels_.finest(); }
  const Level& finest() const { return levels_.finest(); }
  bool is_coarsened() const { return moved_ || levels_.is_coarsened(); }
  void coarsen(const Progress& progress = {});
  void renew();
  void descend(SweepPlan plan);
  bool descend_from_several(int sweeps);

  /// In place of a descent, of levels that are not planned: these phases of own nodes and ghosts,
  /// and sweeps over the finest level.
  void start_from(std::span<const Complex> z, int sweeps) { levels_.start_from(z, sweeps); }

  /// In place of a descent: cycles begin with these phases of own nodes and ghosts.
  void begin_with(std::span<const Complex> z);
  void run_cycles(SweepPlan plan, int cycles, const Progress& progress);
  void relax(Momentum& momentum) { levels_.relax(momentum); }
  double energy() const { return levels_.energy(); }
  Index slots_of_all() const { return solved().slots_of_all(); }
  std::size_t halo_bytes(int sweeps) const { return solved().halo_bytes(sweeps); }
  std::size_t distributed_levels() const { return solved().distributed_levels(); }

  /// Nodes of other ranks beside those that this one solves for.
  std::size_t ghost_count() const { return solved().graph().ghost_count(); }

 private:
  const RankHierarchy& solved() const { return moved_ ? moved_->levels() : levels_; }
  std::size_t gathered_level(const Hierarchy& whole) const;
  void bring_back();

  Communicator& ranks_;
  HierarchyBounds bounds_;
  std::vector<std::uint64_t> ids_;
  RankHierarchy levels_;
  std::optional<MovedLevels> moved_;
};

}  // namespace brindle
