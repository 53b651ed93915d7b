#include "brindle/phases/aggregation.h"

#include <algorithm>

namespace brindle {
namespace {

/// Aggregates of a coarse block, at least: their share of the finer level fits the second cache.
constexpr Index kCoarseBlock = 1536;

/// Members in the order of coarse slots.
void arrange_members(Aggregation& aggregation, const Aggregates& aggregates,
                     const SlicedLayout& coarse) {
  aggregation.member_begin.assign(1, 0);
  aggregation.member_begin.reserve(coarse.slot_count() + 1);
  aggregation.member.reserve(aggregates.member.size());
  for (const Index aggregate : coarse.node_at) {
    if (aggregate != kNone) {
      aggregation.member.insert(aggregation.member.end(),
                                aggregates.member.begin() + aggregates.begin[aggregate],
                                aggregates.member.begin() + aggregates.begin[aggregate + 1]);
    }
    aggregation.member_begin.push_back(static_cast<Index>(aggregation.member.size()));
  }
}

}  // namespace

SlicedLayout coarse_layout(const Aggregates& aggregates, const Adjacency& adjacency,
                           const Coloring& coloring) {
  std::vector<Index> block_ends;
  Index begin = 0;
  for (const Index end : std::span(aggregates.block_begin).subspan(1)) {
    if (end - begin < kCoarseBlock && end < aggregates.count()) continue;
    block_ends.push_back(end);
    begin = end;
    if (end == aggregates.count()) break;
  }
  return sliced_layout(adjacency, coloring, {}, block_ends);
}

Aggregation arrange(const SlicedLayout& fine, const Aggregates& aggregates,
                    const Adjacency& adjacency, const SlicedLayout& coarse,
                    const Progress& progress) {
  Aggregation aggregation;
  arrange_members(aggregation, aggregates, coarse);
  aggregation.coarse_slot = aggregates.aggregate;
  for (Index& slot : aggregation.coarse_slot) {
    slot = slot == kNone ? coarse.slot_count() : coarse.slot_of[slot];
  }
  aggregation.gauges = gauge_rounds(fine, aggregates, progress.part(0.1, 0.5));
  aggregation.sources = source_rounds(fine, aggregates, adjacency, coarse, progress.part(0.5, 1));
  return aggregation;
}

}  // namespace brindle
