/// The multilevel hierarchy: coarser phase graphs whose couplings are exact sums (DESIGN section
/// 3).
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/base/progress.h"
#include "brindle/phases/sliced_graph.h"

namespace brindle {

/// The members that join their aggregates as the (r+1)-th, in groups of kLanes. The gauge of a
/// member hangs on the couplings to earlier members: a round has for every lane one entry of its
/// row that leads to one of them, or kNone.
struct GaugeRank {
  std::vector<Index> member;       ///< slots, kNone for filling; a multiple of kLanes
  std::vector<Index> round_begin;  ///< group g has rounds round_begin[g] .. round_begin[g+1] - 1
  std::vector<Index> entry;        ///< kLanes entries a round
};

/// The fine entries that add to each coarse entry, in rounds: a round has for every lane of a
/// coarse column one fine entry, or the number of fine entries for none.
struct SourceRounds {
  std::vector<Index> round_begin;  ///< coarse column c has rounds round_begin[c] .. [c+1] - 1
  std::vector<Index> entry;        ///< kLanes entries a round
};

/// How the nodes of a level are joined to those of the next coarser one. All in slots of the finer
/// level unless said otherwise. Fixed once the hierarchy is built.
struct Aggregation {
  std::vector<Index> coarse_slot;  ///< slot of the aggregate in the coarser level; its slot_count()
                                   ///< for filling and for nodes without any coupling
  std::vector<Index> member_begin;  ///< coarse slot I has member_begin[I] .. member_begin[I+1] - 1
  std::vector<Index> member;        ///< members of all aggregates, the reference first
  std::vector<GaugeRank> gauge_ranks;  ///< second, third, ... members of all aggregates
  SourceRounds sources;                ///< which entries add to which coarse entry
};

struct Level {
  SlicedLayout layout;
  SlicedCouplings couplings;
  Aggregation aggregation;     ///< empty on the coarsest level
  std::vector<Complex> gauge;  ///< by slot: z_i = g_i Z, or g_i conj(Z) where its conjugate bit
                               ///< (sliced_kernels.h) is set; empty on the coarsest level
  std::vector<Complex> z;  ///< phases by slot; one more, always kPeak, for finer slots without an
                           ///< aggregate
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

/// Renews the couplings and anchors of `coarse` as exact sums of those of `fine`. `gauged` is
/// scratch space with room for the entries of `fine` and one more.
void renew_sums(const Level& fine, Level& coarse, std::span<Complex> gauged);

/// Sets the phases of `fine` from those of `coarse`.
void prolong(const Level& coarse, Level& fine);

}  // namespace brindle
