/// The multilevel hierarchy: coarser phase graphs whose couplings are exact sums (DESIGN section
/// 3).
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/base/progress.h"
#include "brindle/phases/sliced_graph.h"

namespace brindle {

/// How the nodes of a level are joined to those of the next coarser one. All in slots of the finer
/// level unless said otherwise. Fixed once the hierarchy is built.
struct Aggregation {
  std::vector<Index> coarse_slot;   ///< slot of the aggregate in the coarser level; kNone for
                                    ///< filling and for nodes without any coupling
  std::vector<Index> member_begin;  ///< coarse slot I has member_begin[I] .. member_begin[I+1] - 1
  std::vector<Index> member;        ///< members of all aggregates, the reference first
  std::vector<Index> gauge_begin;   ///< member m has gauge_begin[m] .. gauge_begin[m+1] - 1 of...
  std::vector<Index> gauge_entry;   ///< ...the entries in its own row that lead to earlier members
                                    ///< of its aggregate, on which its gauge hangs
  std::vector<Index> coarse_entry;  ///< entry -> entry of the coarser level that it adds to; kNone
                                    ///< inside an aggregate and in filling
};

/// z_i = g_i Z, or g_i conj(Z) where conjugated; by slot of the finer level.
struct Gauges {
  std::vector<Complex> g;
  std::vector<std::uint8_t> conjugated;
};

struct Level {
  SlicedLayout layout;
  SlicedCouplings couplings;
  Aggregation aggregation;  ///< empty on the coarsest level
  Gauges gauges;            ///< empty on the coarsest level
  std::vector<Complex> z;   ///< phases by slot
};

struct Hierarchy {
  std::vector<Level> levels;  ///< finest first

  double topology_milliseconds = 0;  ///< colours, aggregates, layouts
  double numeric_milliseconds = 0;   ///< gauges and sums of the first build
};

/// Nodes that grow into one aggregate.
inline constexpr Index kAggregateSize = 4;

/// The phase that a descent starts from on the coarsest level: the wave's peak, one of the two
/// phases that stay when a direction is turned round (z -> -conj(z)), so that the pattern does not
/// depend on how directions are signed.
inline constexpr Complex kPeak(0, 1);

/// Builds all levels for a graph, until no coupling is left. Aggregates grow one by one, in the
/// order of node numbers: the free neighbour that is most strongly coupled to the aggregate, by sum
/// max(|A|, |B|) / sqrt(deg), joins it until it has `kAggregateSize` members. Nodes left alone join
/// the neighbour's aggregate that they are most strongly coupled to.
Hierarchy build_hierarchy(const PhaseGraph& graph, const Progress& progress = {});

/// Renews the gauges of a level from its couplings.
void renew_gauges(Level& level);

/// Renews the couplings and anchors of `coarse` as exact sums of those of `fine`.
void renew_sums(const Level& fine, Level& coarse);

/// Sets the phases of `fine` from those of `coarse`.
void prolong(const Level& coarse, Level& fine);

}  // namespace brindle
