#include "brindle/phases/aggregates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// The largest number of members before single nodes join.
constexpr Index kMembers = 4;

/// The fewest aggregates per coarse block. Their share of the finer level fits the second cache.
constexpr Index kCoarseBlock = 1536;

float strength(const SlicedLayout& layout, const SlicedCouplings& couplings, Index slot,
               std::size_t entry) {
  const float direct = std::norm(couplings.direct_at(entry));
  const float reflecting = std::norm(couplings.reflecting_at(layout, slot / kLanes, entry));
  return std::sqrt(std::max(direct, reflecting));
}

/// 1 / sqrt(deg_i), deg_i = sum_j |A_ij| + |B_ij|; zero for nodes without any coupling.
std::vector<float> inverse_root_degrees(const SlicedLayout& layout,
                                        const SlicedCouplings& couplings) {
  std::vector<float> result(layout.slot_count());
  parallel_for(result.size(), [&](std::size_t begin, std::size_t end) {
    for (Index slot = static_cast<Index>(begin); slot < end; ++slot) {
      float degree = 0;
      std::size_t entry = layout.first_entry(slot);
      for (Index k = 0; k < layout.width(slot); ++k, entry += kLanes) {
        degree += std::sqrt(std::norm(couplings.direct_at(entry))) +
                  std::sqrt(std::norm(couplings.reflecting_at(layout, slot / kLanes, entry)));
      }
      result[slot] = degree > std::numeric_limits<float>::min() ? 1 / std::sqrt(degree) : 0;
    }
  });
  return result;
}

/// The graph on which aggregates grow.
struct AggregationInput {
  const SlicedLayout& layout;
  const SlicedCouplings& couplings;
  std::vector<float> inverse_root_degree;

  /// Calls `visit(neighbor, strength)` for each coupled neighbour that `counts(neighbor)` accepts.
  template <class Counts, class Visit>
  void for_each_neighbor(Index slot, const Counts& counts, const Visit& visit) const {
    std::size_t entry = layout.first_entry(slot);
    for (Index k = 0; k < layout.width(slot); ++k, entry += kLanes) {
      const Index neighbor = layout.neighbor[entry];
      if (!counts(neighbor)) continue;
      const float s = strength(layout, couplings, slot, entry) * inverse_root_degree[neighbor];
      if (s > 0) visit(neighbor, s);
    }
  }
};

/// A slot joins an aggregate after the aggregate has grown.
struct Join {
  Index aggregate;
  Index slot;
};

/// Members of aggregates in compressed rows.
struct Members {
  std::vector<Index> begin{0};
  std::vector<Index> slots;

  Index count() const { return static_cast<Index>(begin.size()) - 1; }
};

/// Appends joining slots to the members of their aggregates.
Members with_joins(const Members& members, std::vector<Join> joins) {
  if (joins.empty()) return members;
  ranges::stable_sort(joins, {}, &Join::aggregate);
  Members result;
  result.slots.reserve(members.slots.size() + joins.size());
  auto join = joins.begin();
  for (Index a = 0; a < members.count(); ++a) {
    result.slots.insert(result.slots.end(), members.slots.begin() + members.begin[a],
                        members.slots.begin() + members.begin[a + 1]);
    for (; join != joins.end() && join->aggregate == a; ++join) result.slots.push_back(join->slot);
    result.begin.push_back(static_cast<Index>(result.slots.size()));
  }
  return result;
}

/// Grows the aggregates of one block. Their numbers start from 0 in each block.
class BlockGrower {
 public:
  BlockGrower(const AggregationInput& input, SliceRange block, std::vector<Index>& aggregate)
      : input_(input),
        begin_(block.begin * kLanes),
        end_(block.end * kLanes),
        aggregate_(aggregate) {}

  void grow() {
    for (Index slot = begin_; slot < end_; ++slot) {
      if (is_free(slot)) grow_from(slot);
    }
    std::vector<Join> joins;
    for (const Index slot : left_over_) {
      const Index strongest = strongest_aggregate(slot);
      if (strongest == kNone) {
        stranded_.push_back(slot);
      } else {
        joins.push_back({strongest, slot});
      }
    }
    for (const Join& join : joins) aggregate_[join.slot] = join.aggregate;
    members_ = with_joins(members_, std::move(joins));
  }

  const Members& members() const { return members_; }
  /// Slots without a coupling to this block's aggregates.
  const std::vector<Index>& stranded() const { return stranded_; }

 private:
  struct Candidate {
    Index slot;
    float strength;
  };

  bool in_block(Index slot) const { return slot >= begin_ && slot < end_; }
  bool is_free(Index slot) const {
    return in_block(slot) && aggregate_[slot] == kNone && input_.inverse_root_degree[slot] > 0;
  }

  void grow_from(Index seed) {
    candidates_.clear();
    Index next = seed;
    const Index aggregate = members_.count();
    for (Index size = 0; size < kMembers && next != kNone; ++size) {
      aggregate_[next] = aggregate;
      members_.slots.push_back(next);
      add_candidates(next);
      next = take_strongest();
    }
    if (members_.slots.size() - members_.begin.back() > 1) {
      members_.begin.push_back(static_cast<Index>(members_.slots.size()));
      return;
    }
    members_.slots.pop_back();
    aggregate_[seed] = kNone;
    left_over_.push_back(seed);
  }

  /// Adds the couplings of a new member to its free neighbours.
  void add_candidates(Index slot) {
    const auto counts = [&](Index neighbor) { return is_free(neighbor); };
    input_.for_each_neighbor(slot, counts, [&](Index neighbor, float s) {
      const auto known = ranges::find(candidates_, neighbor, &Candidate::slot);
      if (known == candidates_.end()) {
        candidates_.push_back({neighbor, s});
      } else {
        known->strength += s;
      }
    });
  }

  Index take_strongest() {
    const auto best = ranges::max_element(candidates_, {}, &Candidate::strength);
    if (best == candidates_.end()) return kNone;
    const Index slot = best->slot;
    candidates_.erase(best);
    return slot;
  }

  Index strongest_aggregate(Index slot) const {
    Candidate best{kNone, 0};
    const auto counts = [&](Index neighbor) {
      return in_block(neighbor) && aggregate_[neighbor] != kNone;
    };
    input_.for_each_neighbor(slot, counts, [&](Index neighbor, float s) {
      if (s > best.strength) best = {aggregate_[neighbor], s};
    });
    return best.slot;
  }

  const AggregationInput& input_;
  Index begin_, end_;
  std::vector<Index>& aggregate_;
  Members members_;
  std::vector<Candidate> candidates_;
  std::vector<Index> left_over_;
  std::vector<Index> stranded_;
};

/// Numbers the aggregates consecutively over all blocks.
Aggregates put_together(const SlicedLayout& layout, const std::vector<BlockGrower>& growers,
                        std::vector<Index> aggregate) {
  Aggregates aggregates;
  for (const BlockGrower& grower : growers) {
    append_list(aggregates.member, grower.members().slots);
    append_offsets(aggregates.begin, grower.members().begin);
    aggregates.block_begin.push_back(aggregates.count());
  }
  parallel_for(
      growers.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
          const SliceRange block = layout.block(static_cast<Index>(b));
          for (Index slot = block.begin * kLanes; slot < block.end * kLanes; ++slot) {
            if (aggregate[slot] != kNone) aggregate[slot] += aggregates.block_begin[b];
          }
        }
      },
      1);
  aggregates.aggregate = std::move(aggregate);
  return aggregates;
}

/// Joins a stranded slot to the aggregate of a neighbour in another block, or to a stranded one.
class StrandedJoiner {
 public:
  StrandedJoiner(const AggregationInput& input, Aggregates& aggregates)
      : input_(input), aggregates_(aggregates), members_{aggregates.begin, aggregates.member} {}

  void join(Index slot) {
    if (aggregates_.aggregate[slot] != kNone) return;
    Index strongest = kNone;
    float greatest = 0;
    const auto all = [](Index) { return true; };
    input_.for_each_neighbor(slot, all, [&](Index neighbor, float s) {
      const bool joined = aggregates_.aggregate[neighbor] != kNone;
      const bool better = strongest == kNone || aggregates_.aggregate[strongest] == kNone;
      if (joined ? (better || s > greatest) : (strongest == kNone)) {
        strongest = neighbor;
        greatest = s;
      }
    });
    if (strongest == kNone) return;
    if (aggregates_.aggregate[strongest] == kNone) {
      aggregates_.aggregate[strongest] = members_.count();
      members_.slots.push_back(strongest);
      members_.begin.push_back(static_cast<Index>(members_.slots.size()));
    }
    aggregates_.aggregate[slot] = aggregates_.aggregate[strongest];
    joins_.push_back({aggregates_.aggregate[slot], slot});
  }

  void finish() {
    Members joined = with_joins(members_, std::move(joins_));
    aggregates_.begin = std::move(joined.begin);
    aggregates_.member = std::move(joined.slots);
    aggregates_.block_begin.back() = aggregates_.count();
  }

 private:
  const AggregationInput& input_;
  Aggregates& aggregates_;
  Members members_;
  std::vector<Join> joins_;
};

void join_stranded(const AggregationInput& input, const std::vector<BlockGrower>& growers,
                   Aggregates& aggregates) {
  if (ranges::all_of(growers, [](const auto& grower) { return grower.stranded().empty(); })) {
    return;
  }
  StrandedJoiner joiner(input, aggregates);
  for (const BlockGrower& grower : growers) {
    for (const Index slot : grower.stranded()) joiner.join(slot);
  }
  joiner.finish();
}

/// Insertion sort is faster for short rows.
void sort_row(std::vector<Index>& row) {
  constexpr std::size_t kFew = 16;
  if (row.size() > kFew) {
    ranges::sort(row.begin(), row.end());
    return;
  }
  for (std::size_t i = 1; i < row.size(); ++i) {
    const Index value = row[i];
    std::size_t place = i;
    for (; place > 0 && row[place - 1] > value; --place) row[place] = row[place - 1];
    row[place] = value;
  }
}

/// Writes the neighbours of an aggregate into `row`, ascending. `seen_by[a]` is the last aggregate
/// whose row contained a; it avoids duplicates.
void collect_row(const SlicedLayout& layout, const Aggregates& aggregates, Index aggregate,
                 std::vector<Index>& seen_by, std::vector<Index>& row) {
  row.clear();
  for (Index m = aggregates.begin[aggregate]; m < aggregates.begin[aggregate + 1]; ++m) {
    const Index slot = aggregates.member[m];
    std::size_t entry = layout.first_entry(slot);
    for (Index k = 0; k < layout.width(slot); ++k, entry += kLanes) {
      const Index other = aggregates.aggregate[layout.neighbor[entry]];
      if (other == kNone || other == aggregate || seen_by[other] == aggregate) continue;
      seen_by[other] = aggregate;
      row.push_back(other);
    }
  }
  sort_row(row);
}

}  // namespace

Aggregates grow_aggregates(const SlicedLayout& layout, const SlicedCouplings& couplings,
                           const Progress& progress) {
  const AggregationInput input{layout, couplings, inverse_root_degrees(layout, couplings)};
  std::vector<Index> aggregate(layout.slot_count(), kNone);
  std::vector<BlockGrower> growers;
  for (Index block = 0; block < layout.block_count(); ++block) {
    growers.emplace_back(input, layout.block(block), aggregate);
  }
  for_blocks(growers.size(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) growers[block].grow();
  });
  Aggregates aggregates = put_together(layout, growers, std::move(aggregate));
  join_stranded(input, growers, aggregates);
  return aggregates;
}

Adjacency coarse_adjacency(const SlicedLayout& layout, const Aggregates& aggregates) {
  const std::size_t blocks = aggregates.block_begin.size() - 1;
  std::vector<Adjacency> parts(blocks);
  parallel_for(
      blocks,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Index> row, seen_by(aggregates.count(), kNone);
        for (std::size_t block = begin; block < end; ++block) {
          Adjacency& part = parts[block];
          for (Index a = aggregates.block_begin[block]; a < aggregates.block_begin[block + 1];
               ++a) {
            collect_row(layout, aggregates, a, seen_by, row);
            part.neighbors.insert(part.neighbors.end(), row.begin(), row.end());
            part.offsets.push_back(static_cast<Index>(part.neighbors.size()));
          }
        }
      },
      1);
  Adjacency adjacency;
  reserve_for_lists(adjacency.offsets, parts, &Adjacency::offsets);
  reserve_for_lists(adjacency.neighbors, parts, &Adjacency::neighbors);
  for (const Adjacency& part : parts) {
    append_list(adjacency.neighbors, part.neighbors);
    append_offsets(adjacency.offsets, part.offsets);
  }
  return adjacency;
}

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

}  // namespace brindle
