/// The multilevel solver over ranks: each has its part of the finer levels, rank 0 the coarser ones
/// (docs/distributed.md).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brindle/distributed/levels/gathered_levels.h"
#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/progress.h"

namespace brindle {

/// With one rank, all that this does is what a Hierarchy and the functions of phases/multilevel.h
/// do, bit by bit. All functions but `finest` must be called by all ranks, and `ranks` must live as
/// long.
class RankHierarchy {
 public:
  /// The finest level alone. Coarser ones that have fewer nodes than `gather_below` on all ranks
  /// together are gathered on rank 0.
  RankHierarchy(Communicator& ranks, RankGraph graph, std::size_t gather_below);

  /// Its couplings are for the caller to set, for own slots; `z` has ghosts' phases, too. `coarsen`
  /// moves it.
  Level& finest() { return hierarchy_.levels[0]; }
  const Level& finest() const { return hierarchy_.levels[0]; }
  bool is_coarsened() const { return is_coarsened_; }

  /// As the functions of the same names in phases/hierarchy.h and phases/multilevel.h. `progress`
  /// cancels all ranks if it does one.
  void coarsen(const Progress& progress = {});
  void renew();
  void descend(SweepPlan plan);
  void run_cycles(SweepPlan plan, int cycles, const Progress& progress);

  /// One iteration of the paper's relaxation over all colours of the finest level.
  void relax(Momentum& momentum);

  /// Of the finest level's phases, over all ranks.
  double energy() const;

  /// Those of the finest level on all ranks.
  Index slots_of_all() const { return parts_[0].slots_of_all; }

  /// Bytes that the sweeps of a descent have to bring to this rank: 8 for each ghost, sweep and
  /// distributed level.
  std::size_t halo_bytes(int sweeps) const;

  /// How many levels the ranks have parts of; those that are gathered do not count.
  std::size_t distributed_levels() const { return parts_.size() - (gathered_ ? 1 : 0); }

 private:
  /// What a level has beside a Level.
  struct Part {
    RankGraph graph;
    Index color_count = 0;
    SlotHalo halo;
    Index slots_of_all = 0;            ///< of own nodes, on all ranks
    std::vector<Index> inner, border;  ///< blocks of the coarser level whose sums need no gauges
                                       ///< of ghosts, and those that do
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
  std::vector<Part> parts_;                 ///< beside the levels
  std::optional<GatheredLevels> gathered_;  ///< the last level and all coarser ones
  bool is_coarsened_ = false;
};

}  // namespace brindle
