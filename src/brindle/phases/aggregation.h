/// Aggregates: which nodes of a level become one node of the next coarser one.
#pragma once

#include <span>
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

/// How gauges hang on each other: that of an aggregate's r-th member on the couplings to earlier
/// members. Aggregates that grew one after the other, and so lie close together, form a chunk; no
/// gauge hangs on another chunk's. A range of a chunk holds the members of one rank r, from the
/// second up, in groups of kLanes; a round has for every lane of a group one entry of its row that
/// leads to an earlier member, or kNone.
struct GaugeRounds {
  std::vector<Index> chunk_begin{0};  ///< chunk c has ranges chunk_begin[c] .. [c+1] - 1
  std::vector<SliceRange> ranges;     ///< groups of one rank in one chunk
  std::vector<Index> member;          ///< kLanes slots a group, kNone for filling
  std::vector<Index> round_begin{0};  ///< group g has rounds round_begin[g] .. [g+1] - 1
  std::vector<Index> entry;           ///< kLanes entries a round

  Index chunk_count() const { return static_cast<Index>(chunk_begin.size()) - 1; }
  std::span<const SliceRange> ranges_of(Index chunk) const {
    return std::span(ranges).subspan(chunk_begin[chunk],
                                     chunk_begin[chunk + 1] - chunk_begin[chunk]);
  }
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
  GaugeRounds gauges;               ///< the order in which gauges follow from couplings
  SourceRounds sources;             ///< which entries add to which coarse entry
};

/// Arranges a matching for the kernels; `adjacency` is its coarse adjacency and `coarse` the layout
/// of that.
Aggregation arrange(const SlicedLayout& fine, const Matching& matching, const Adjacency& adjacency,
                    const SlicedLayout& coarse);

}  // namespace brindle
