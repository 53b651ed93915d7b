/// Aggregates: which nodes of a level become one node of the next coarser one.
#pragma once

#include <vector>

#include "brindle/base/adjacency.h"
#include "brindle/phases/sliced_graph.h"

namespace brindle {

/// Nodes that grow into one aggregate.
inline constexpr Index kAggregateSize = 4;

/// Which aggregate each slot belongs to; aggregates are numbered in the order in which they grew.
struct Matching {
  std::vector<Index> aggregate;  ///< slot -> aggregate or kNone
  std::vector<Index> begin{0};   ///< aggregate a has members begin[a] .. begin[a+1] - 1
  std::vector<Index> member;     ///< slots, in the order in which they joined

  Index count() const { return static_cast<Index>(begin.size()) - 1; }
};

/// Aggregates grow one by one, in the order of slots: the free neighbour that is most
/// strongly coupled to the aggregate, by sum max(|A|, |B|) / sqrt(deg), joins it until it has
/// `kAggregateSize` members. Nodes left alone join the neighbour's aggregate that they are most
/// strongly coupled to; nodes without any coupling stay outside.
Matching grow_aggregates(const SlicedLayout& layout, const SlicedCouplings& couplings);

/// Aggregates are neighbours if some of their members are.
Adjacency coarse_adjacency(const SlicedLayout& layout, const Matching& matching);

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

/// Arranges a matching for the kernels; `adjacency` is its coarse adjacency and `coarse` the layout
/// of that.
Aggregation arrange(const SlicedLayout& fine, const Matching& matching, const Adjacency& adjacency,
                    const SlicedLayout& coarse);

}  // namespace brindle
