/// The distributed multilevel solver: finer levels are distributed, coarser ones are on rank 0
/// (docs/distributed.md).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/distributed/parts_on_first.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/progress.h"

namespace brindle {

// Coarse levels that rank 0 holds alone.

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
  void gather_couplings(Communicator& ranks, const Level& level);
  void load_first(std::span<const Complex> direct, std::span<const Complex> anchors,
                  std::vector<ReflectingCoupling> reflecting);
  void scatter(Level& level);

  std::shared_ptr<const Adjacency> adjacency_;  ///< of own nodes
  PartsOnFirst nodes_, edges_;
  std::vector<Complex> own_z_;
  // On rank 0 only.
  Hierarchy hierarchy_;
  std::vector<Index> entry_of_;  ///< of each edge in the first level's layout
  std::vector<Complex> z_;
};

/// One rank gives the bits of a Hierarchy with the functions of phases/multilevel.h. All functions
/// but `finest` are collective; `ranks` must outlive this object.
class RankHierarchy {
 public:
  /// Creates the finest level. Coarser levels with fewer than `gather_below` nodes in total are
  /// gathered on rank 0.
  RankHierarchy(Communicator& ranks, RankGraph graph, std::size_t gather_below);

  /// The caller sets the couplings of own slots; `z` includes ghosts. `coarsen` moves the level.
  Level& finest() { return hierarchy_.levels[0]; }
  const Level& finest() const { return hierarchy_.levels[0]; }
  bool is_coarsened() const { return is_coarsened_; }

  /// As the functions of the same names in phases/hierarchy.h and phases/multilevel.h. If
  /// `progress` throws on one rank, all ranks throw; `descend` reports nothing.
  void coarsen(const Progress& progress = {});
  void renew();
  void descend(SweepPlan plan, const Progress& progress = {});
  void run_cycles(SweepPlan plan, int cycles, const Progress& progress);

  /// One iteration of the paper's relaxation over all colours of the finest level.
  void relax(Momentum& momentum);

  /// The energy of the finest level's phases, over all ranks.
  double energy() const;

  /// The slots of the finest level, over all ranks.
  Index slots_of_all() const { return parts_[0].slots_of_all; }

  /// Bytes that the sweeps of a descent bring to this rank: 8 per ghost, sweep and distributed
  /// level.
  std::size_t halo_bytes(int sweeps) const;

  /// The number of distributed levels, without gathered ones.
  std::size_t distributed_levels() const { return parts_.size() - (gathered_ ? 1 : 0); }

 private:
  /// The distributed data of a level.
  struct Part {
    RankGraph graph;
    Index color_count = 0;
    SlotHalo halo;
    Index slots_of_all = 0;  ///< of own nodes, over all ranks
    std::vector<Index> inner,
        border;  ///< blocks of the coarser level whose sums do not need, or need, gauges of ghosts
    std::size_t nodes_of_all = 0;
  };

  void add_level(RankGraph graph, Level level, const Coloring& coloring);
  bool is_small(std::size_t level) const;
  bool add_coarser();
  void set_blocks(Part& part, const Level& fine, const Level& coarse) const;
  void renew_sums_to(std::size_t coarse);
  template <class Update>
  void for_each_color(std::size_t level, std::span<Complex> z, const Update& update);
  void sweep_level(std::size_t level, SweepPlan plan);
  void descend_from(Complex start, SweepPlan plan);
  void correct(SweepPlan plan);

  Communicator& ranks_;
  std::size_t gather_below_ = 0;
  Hierarchy hierarchy_;
  std::vector<Part> parts_;                 ///< parallel to the levels
  std::optional<GatheredLevels> gathered_;  ///< the last level and all coarser ones
  bool is_coarsened_ = false;
};

}  // namespace brindle
