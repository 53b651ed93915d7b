/// The fine couplings that add to each coarse coupling.
#pragma once

#include <span>
#include <vector>

#include "brindle/phases/aggregates.h"
#include "brindle/progress.h"

namespace brindle {

/// The sums of the coarse couplings, block by block of the coarse layout, so that a block's share
/// of the finer level stays in the cache. First the rows of its members are turned into their
/// gauges: slice by slice, as its runs tell, one entry after the other from place kLanes on of a
/// scratch space whose place 0 is zero. Then a round names for every lane of a coarse column one
/// place, or 0.
struct SourceRounds {
  std::vector<Index> run_begin{0};    ///< coarse block b has runs run_begin[b] .. [b+1] - 1
  std::vector<SliceRange> runs;       ///< fine slices, ascending in a block
  std::vector<Index> round_begin{0};  ///< coarse column c has rounds round_begin[c] .. [c+1] - 1
  std::vector<Index> entry;           ///< kLanes places a round
  std::size_t places = kLanes;        ///< that the largest block needs

  std::span<const SliceRange> runs_of(Index block) const {
    return std::span(runs).subspan(run_begin[block], run_begin[block + 1] - run_begin[block]);
  }
};

/// `adjacency` is the coarse adjacency of `aggregates` and `coarse` the layout of that.
SourceRounds source_rounds(const SlicedLayout& fine, const Aggregates& aggregates,
                           const Adjacency& adjacency, const SlicedLayout& coarse,
                           const Progress& progress = {});

/// What stands at every place of a block's scratch space: an entry of the finer level, kNone below
/// kLanes.
std::vector<Index> entries_of_places(const SourceRounds& sources, const SlicedLayout& fine,
                                     Index block);

}  // namespace brindle
