/// How the nodes of a level are joined to those of the next coarser one.
#pragma once

#include <vector>

#include "brindle/phases/aggregates.h"
#include "brindle/phases/gauge_rounds.h"
#include "brindle/phases/source_rounds.h"
#include "brindle/progress.h"

namespace brindle {

/// All in slots of the finer level unless said otherwise. Fixed once the hierarchy is built.
struct Aggregation {
  std::vector<Index> coarse_slot;  ///< slot of the aggregate in the coarser level; its slot_count()
                                   ///< for filling and for nodes without any coupling
  std::vector<Index> member_begin;  ///< coarse slot I has member_begin[I] .. member_begin[I+1] - 1
  std::vector<Index> member;        ///< members of all aggregates, the reference first
  GaugeRounds gauges;               ///< the order in which gauges follow from couplings
  SourceRounds sources;             ///< which entries add to which coarse entry
};

/// The layout of the coarser level in these colours: its blocks hold the aggregates of a few whole
/// blocks of the finer one.
SlicedLayout coarse_layout(const Aggregates& aggregates, const Adjacency& adjacency,
                           const Coloring& coloring);

/// Arranges aggregates for the kernels; `adjacency` is its coarse adjacency and `coarse` the
/// layout of that.
Aggregation arrange(const SlicedLayout& fine, const Aggregates& aggregates,
                    const Adjacency& adjacency, const SlicedLayout& coarse,
                    const Progress& progress = {});

}  // namespace brindle
