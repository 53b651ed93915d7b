/// The order in which couplings are summed over aggregates (docs/method.md, "Multilevel solver").
#pragma once

#include <span>
#include <vector>

#include "brindle/phases/aggregates.h"
#include "brindle/phases/sliced_graph.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// The dependency order of gauges: the gauge of an aggregate's r-th member depends on couplings to
/// earlier members. The aggregates of a block form a chunk; chunks are independent. A range holds
/// the members of one rank r, from the second up, in groups of kLanes. A round has, per lane, one
/// entry of the member's row and the slot of the earlier member to which it leads, or kNone.
struct GaugeSchedule {
  std::vector<Index> chunk_begin{0};  ///< chunk c has ranges chunk_begin[c] .. [c+1] - 1
  std::vector<SliceRange> ranges;     ///< groups of one rank in one chunk
  std::vector<Index> member;          ///< kLanes slots per group, kNone for padding
  std::vector<Index> round_begin{0};  ///< group g has rounds round_begin[g] .. [g+1] - 1
  std::vector<Index> entry;           ///< kLanes entries per round
  std::vector<Index> from;            ///< the slot to which each entry leads; 0 for kNone

  Index chunk_count() const { return static_cast<Index>(chunk_begin.size()) - 1; }
  std::span<const SliceRange> ranges_of(Index chunk) const {
    return std::span(ranges).subspan(chunk_begin[chunk],
                                     chunk_begin[chunk + 1] - chunk_begin[chunk]);
  }
};

/// The fine couplings that add to each coarse coupling. Coarse blocks are processed one by one so
/// that their share of the finer level stays in the cache. First, the rows of a block's members are
/// multiplied by their gauges, slice by slice of its runs. The products fill a scratch array from
/// place kLanes on; place 0 is zero. A round has, per lane of a coarse column, one place, or 0.
struct SumSchedule {
  std::vector<Index> run_begin{0};    ///< coarse block b has runs run_begin[b] .. [b+1] - 1
  std::vector<SliceRange> runs;       ///< fine slices, ascending in a block
  std::vector<Index> round_begin{0};  ///< coarse column c has rounds round_begin[c] .. [c+1] - 1
  std::vector<Index> entry;           ///< kLanes places per round
  std::size_t places = kLanes;        ///< size of the scratch array for the largest block

  std::span<const SliceRange> runs_of(Index block) const {
    return std::span(runs).subspan(run_begin[block], run_begin[block + 1] - run_begin[block]);
  }
};

/// The finer level's entry at each place of a block's scratch array; kNone below kLanes.
std::vector<Index> entries_of_places(const SumSchedule& sources, const SlicedLayout& fine,
                                     Index block);

/// Aggregates as kernels read them, in slots of the finer level unless noted otherwise. Constant
/// once the hierarchy is built.
struct Aggregation {
  std::vector<Index> coarse_slot;   ///< slot in the coarser level, or its slot_count() for padding
                                    ///< and uncoupled nodes
  std::vector<Index> member_begin;  ///< coarse slot I has member_begin[I] .. member_begin[I+1] - 1
  std::vector<Index> member;        ///< members of all aggregates, the reference first
  GaugeSchedule gauges;
  SumSchedule sources;
};

/// `adjacency` is the coarse adjacency of the aggregates and `coarse` its layout.
Aggregation arrange(const SlicedLayout& fine, const Aggregates& aggregates,
                    const Adjacency& adjacency, const SlicedLayout& coarse,
                    const Progress& progress = {});

}  // namespace brindle
