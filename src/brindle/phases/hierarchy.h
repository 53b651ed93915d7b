/// The multilevel hierarchy: coarser phase graphs whose couplings are exact sums (docs/method.md,
/// "Multilevel solver").
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "brindle/phases/aggregation.h"
#include "brindle/phases/sliced_graph.h"
#include "brindle/progress.h"

namespace brindle {

/// The part of a level that depends on connectivity alone, shared by the levels of several fields.
struct LevelTopology {
  std::shared_ptr<const SlicedLayout> layout;
  std::shared_ptr<const Aggregation> aggregation;  ///< null on the coarsest level
};

/// One phase graph of the hierarchy, with the gauges of its nodes.
struct Level {
  LevelTopology topology;
  SlicedCouplings couplings;
  std::vector<Complex> gauge;  ///< by slot: z_i = g_i Z, or g_i conj(Z) where its conjugate bit
                               ///< (sliced_kernels.h) is set; unused on the coarsest level
  std::vector<Complex> z;      ///< phases by slot, plus kPeak for finer slots without aggregate
  std::vector<std::uint8_t> receives_reflecting;  ///< scratch of `renew_sums`, by slot

  const SlicedLayout& layout() const { return *topology.layout; }
  const Aggregation& aggregation() const { return *topology.aggregation; }
};

/// A level of this topology; couplings, gauges and phases are not yet set.
Level make_level(LevelTopology topology);

/// Scratch memory of `renew_sums`, one set per thread.
struct SumScratch {
  struct OfThread {
    std::vector<Complex> gauged;       ///< SumSchedule::places numbers, the first kLanes zero
    std::vector<std::uint8_t> marked;  ///< by coarse slice
    std::vector<Complex> reflecting;   ///< by entry of one coarse slice
  };
  std::vector<OfThread> threads;
  std::size_t places = 0, slices = 0, entries = 0;  ///< sizes of each set

  /// Allocates memory for the sums of all levels.
  void reserve(std::span<const Level> levels);

  /// Allocates the same memory for threads that joined later; otherwise allocates nothing.
  void reserve_threads();

 private:
  void make_room(OfThread& own) const;
};

/// All levels, and the times to build them.
struct Hierarchy {
  std::vector<Level> levels;  ///< finest first
  SumScratch scratch;
  bool corrected = false;  ///< until `renew`, the finest level's gauges are a cycle's phases

  double topology_milliseconds = 0;  ///< colours, aggregates, layouts
  double numeric_milliseconds = 0;   ///< gauges and sums of the first build
};

/// The start of a descent on the coarsest level: the peak of the wave. Reversing a direction (z ->
/// -conj(z)) does not change this phase, so results do not depend on signs of directions.
inline constexpr Complex kPeak(0, 1);

/// The finest level alone, laid out for these neighbour lists; couplings are not yet set.
Hierarchy finest_level(const Adjacency& adjacency, const Progress& progress = {});

/// Adds coarser levels until no coupling is left. Aggregates follow the couplings of each level
/// (`grow_aggregates`); gauges and sums are those of `renew`. Throws Cancelled if `progress`
/// cancels; the hierarchy is then unusable.
void coarsen(Hierarchy& hierarchy, const Progress& progress = {});

/// All levels of a graph.
Hierarchy build_hierarchy(const PhaseGraph& graph, const Progress& progress = {});

/// Levels of the same topology for a second field on the same graph. Couplings, gauges and phases
/// are not yet set.
Hierarchy sibling(const Hierarchy& hierarchy);

/// Updates the gauges of a level from its couplings; those of first members stay 1.
void renew_gauges(Level& level);

/// Updates the couplings and anchors of `coarse` as exact sums of those of `fine`.
void renew_sums(const Level& fine, Level& coarse, SumScratch& scratch);

/// Updates only these blocks of `coarse`.
void renew_sums(const Level& fine, Level& coarse, SumScratch& scratch,
                std::span<const Index> blocks);

/// Resets the gauges of first members to 1 after a cycle.
void reset_gauges(Hierarchy& hierarchy);

/// Updates the gauges and sums of all levels from the couplings of the finest level.
void renew(Hierarchy& hierarchy);

/// Sets the phases of `fine` from those of `coarse`.
void prolong(const Level& coarse, Level& fine);

}  // namespace brindle
