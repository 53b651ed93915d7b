/// The order in which the gauges of a level follow from its couplings.
#pragma once

#include <span>
#include <vector>

#include "brindle/phases/aggregates.h"
#include "brindle/progress.h"

namespace brindle {

/// How gauges hang on each other: that of an aggregate's r-th member on the couplings to earlier
/// members. The aggregates of a block form a chunk; no gauge hangs on another chunk's. A range of a
/// chunk holds the members of one rank r, from the second up, in groups of kLanes; a round has for
/// every lane of a group one entry of its row that leads to an earlier member, and that member's
/// slot, or kNone.
struct GaugeRounds {
  std::vector<Index> chunk_begin{0};  ///< chunk c has ranges chunk_begin[c] .. [c+1] - 1
  std::vector<SliceRange> ranges;     ///< groups of one rank in one chunk
  std::vector<Index> member;          ///< kLanes slots a group, kNone for filling
  std::vector<Index> round_begin{0};  ///< group g has rounds round_begin[g] .. [g+1] - 1
  std::vector<Index> entry;           ///< kLanes entries a round
  std::vector<Index> from;            ///< the slot that each entry leads to; 0 for kNone

  Index chunk_count() const { return static_cast<Index>(chunk_begin.size()) - 1; }
  std::span<const SliceRange> ranges_of(Index chunk) const {
    return std::span(ranges).subspan(chunk_begin[chunk],
                                     chunk_begin[chunk + 1] - chunk_begin[chunk]);
  }
};

GaugeRounds gauge_rounds(const SlicedLayout& layout, const Aggregates& aggregates,
                         const Progress& progress = {});

}  // namespace brindle
