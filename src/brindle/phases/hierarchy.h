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

/// The part of a level that depends on connectivity alone. Levels of several fields share it.
struct LevelTopology {
  std::shared_ptr<const SlicedLayout> layout;
  std::shared_ptr<const Aggregation> aggregation;  ///< none on the coarsest level
};

struct Level {
  LevelTopology topology;
  SlicedCouplings couplings;
  std::vector<Complex> gauge;  ///< by slot: z_i = g_i Z, or g_i conj(Z) where its conjugate bit
                               ///< (sliced_kernels.h) is set; unused on the coarsest level
  std::vector<Complex> z;      ///< phases by slot; one more, always kPeak, for finer slots without
                               ///< an aggregate
  std::vector<std::uint8_t> receives_reflecting;  ///< scratch of `renew_sums`, by slot

  const SlicedLayout& layout() const { return *topology.layout; }
  const Aggregation& aggregation() const { return *topology.aggregation; }
};

/// A level of this topology whose couplings, gauges and phases are not yet set.
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

  /// Makes room for the sums of all levels.
  void reserve(std::span<const Level> levels);

  /// Makes the same room for threads that have joined since. Allocates nothing otherwise.
  void reserve_threads();

 private:
  void make_room(OfThread& own) const;
};

struct Hierarchy {
  std::vector<Level> levels;  ///< finest first
  SumScratch scratch;
  bool corrected = false;  ///< the finest level's gauges are a cycle's phases, until `renew`

  double topology_milliseconds = 0;  ///< colours, aggregates, layouts
  double numeric_milliseconds = 0;   ///< gauges and sums of the first build
};

/// The start of a descent on the coarsest level: the peak of the wave, one of the two phases that
/// stay when a direction is reversed (z -> -conj(z)), so that signs of directions change nothing.
inline constexpr Complex kPeak(0, 1);

/// The finest level alone, laid out for these neighbour lists; its couplings are not yet set.
Hierarchy finest_level(const Adjacency& adjacency, const Progress& progress = {});

/// Adds the coarser levels, until no coupling is left. Aggregates follow the couplings of each
/// level (`grow_aggregates`); gauges and sums are those of `renew`. Throws Cancelled if `progress`
/// asks for it; the hierarchy is then unusable.
void coarsen(Hierarchy& hierarchy, const Progress& progress = {});

/// All levels of a graph.
Hierarchy build_hierarchy(const PhaseGraph& graph, const Progress& progress = {});

/// Levels of the same topology whose couplings, gauges and phases are not yet set: for a second
/// field on the same graph.
Hierarchy sibling(const Hierarchy& hierarchy);

/// Renews the gauges of a level from its couplings; those of first members stay 1.
void renew_gauges(Level& level);

/// Renews the couplings and anchors of `coarse` as exact sums of those of `fine`.
void renew_sums(const Level& fine, Level& coarse, SumScratch& scratch);

/// The same for these blocks of `coarse` alone.
void renew_sums(const Level& fine, Level& coarse, SumScratch& scratch,
                std::span<const Index> blocks);

/// Makes the gauges of first members 1 again after a cycle.
void reset_gauges(Hierarchy& hierarchy);

/// Renews the gauges and sums of all levels from the couplings of the finest.
void renew(Hierarchy& hierarchy);

/// Sets the phases of `fine` from those of `coarse`.
void prolong(const Level& coarse, Level& fine);

}  // namespace brindle
