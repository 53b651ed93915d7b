#include "brindle/phases/aggregation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// Members up to which an aggregate grows.
constexpr Index kMembers = 4;

/// Aggregates of a coarse block, at least: their share of the finer level fits the second cache.
constexpr Index kCoarseBlock = 1536;

// ---- Lists of blocks, one after the other ------------------------------------------------------

/// Makes room for a list of all parts.
template <class Part>
void reserve(std::vector<Index>& all, const std::vector<Part>& parts,
             std::vector<Index> Part::*list) {
  std::size_t size = all.size();
  for (const Part& part : parts) size += (part.*list).size();
  all.reserve(size);
}

void append(std::vector<Index>& all, const std::vector<Index>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

/// Offsets, the first of which is 0, continue those before.
void append_offsets(std::vector<Index>& all, const std::vector<Index>& part) {
  const Index first = all.back();
  for (std::size_t n = 1; n < part.size(); ++n) all.push_back(first + part[n]);
}

// ---- Aggregates --------------------------------------------------------------------------------

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

  /// Calls `visit(neighbor, strength)` for the coupled neighbours of a slot for which
  /// `counts(neighbor)` holds.
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

/// Grows the aggregates of one block. Numbers of aggregates start from 0 in each block.
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
  /// Slots that are coupled to none of this block's aggregates.
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

/// The aggregates of all blocks, numbered one after the other.
Aggregates put_together(const SlicedLayout& layout, const std::vector<BlockGrower>& growers,
                        std::vector<Index> aggregate) {
  Aggregates aggregates;
  for (const BlockGrower& grower : growers) {
    append(aggregates.member, grower.members().slots);
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

/// Joins a stranded slot to a neighbour's aggregate in another block, or to a stranded neighbour.
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

/// By insertion, which is faster for short rows.
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

/// Writes the neighbours of an aggregate into `row`, ascending. `seen_by` has, for every aggregate,
/// the last one in whose row it was found.
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
  reserve(adjacency.offsets, parts, &Adjacency::offsets);
  reserve(adjacency.neighbors, parts, &Adjacency::neighbors);
  for (const Adjacency& part : parts) {
    append(adjacency.neighbors, part.neighbors);
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

namespace {

// ---- Gauges ------------------------------------------------------------------------------------

/// The rank of every slot: its place in its aggregate.
std::vector<Index> ranks(const SlicedLayout& layout, const Aggregates& aggregates) {
  std::vector<Index> rank_of(layout.slot_count(), 0);
  for (Index a = 0; a < aggregates.count(); ++a) {
    for (Index m = aggregates.begin[a]; m < aggregates.begin[a + 1]; ++m) {
      rank_of[aggregates.member[m]] = m - aggregates.begin[a];
    }
  }
  return rank_of;
}

/// The gauges of one chunk.
class ChunkGauges {
 public:
  ChunkGauges(const SlicedLayout& layout, const Aggregates& aggregates,
              const std::vector<Index>& rank_of)
      : layout_(layout), aggregates_(aggregates), rank_of_(rank_of) {}

  GaugeRounds arrange(Index first, Index end) {
    for (Index rank = 1; collect_members(first, end, rank); ++rank) add_range();
    return std::move(rounds_);
  }

 private:
  /// The members of one rank, ascending: couplings are read in the order of memory.
  bool collect_members(Index first, Index end, Index rank) {
    members_.clear();
    for (Index a = first; a < end; ++a) {
      const Index m = aggregates_.begin[a] + rank;
      if (m < aggregates_.begin[a + 1]) members_.push_back(aggregates_.member[m]);
    }
    ranges::sort(members_);
    while (members_.size() % kLanes != 0) members_.push_back(kNone);
    return !members_.empty();
  }

  void add_range() {
    const auto first = static_cast<Index>(rounds_.member.size() / kLanes);
    for (std::size_t group = 0; group < members_.size(); group += kLanes) {
      add_group(std::span(members_).subspan(group, kLanes));
    }
    rounds_.ranges.push_back({first, static_cast<Index>(rounds_.member.size() / kLanes)});
  }

  void add_group(std::span<const Index> group) {
    const std::size_t first = rounds_.entry.size();
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (group[lane] == kNone) continue;
      collect_entries(group[lane]);
      if (rounds_.entry.size() < first + entries_.size() * kLanes) {
        rounds_.entry.resize(first + entries_.size() * kLanes, kNone);
        rounds_.from.resize(rounds_.entry.size());
      }
      for (std::size_t e = 0; e < entries_.size(); ++e) {
        rounds_.entry[first + e * kLanes + lane] = entries_[e];
        rounds_.from[first + e * kLanes + lane] = layout_.neighbor[entries_[e]];
      }
    }
    rounds_.member.insert(rounds_.member.end(), group.begin(), group.end());
    rounds_.round_begin.push_back(static_cast<Index>(rounds_.entry.size() / kLanes));
  }

  /// Entries in the row of a member that lead to members of its aggregate with a lower rank.
  void collect_entries(Index slot) {
    entries_.clear();
    std::size_t entry = layout_.first_entry(slot);
    for (Index k = 0; k < layout_.width(slot); ++k, entry += kLanes) {
      const Index j = layout_.neighbor[entry];
      if (aggregates_.aggregate[j] == aggregates_.aggregate[slot] && rank_of_[j] < rank_of_[slot]) {
        entries_.push_back(static_cast<Index>(entry));
      }
    }
  }

  const SlicedLayout& layout_;
  const Aggregates& aggregates_;
  const std::vector<Index>& rank_of_;
  std::vector<Index> members_;
  std::vector<Index> entries_;
  GaugeRounds rounds_;
};

GaugeRounds gauge_rounds(const SlicedLayout& layout, const Aggregates& aggregates,
                         const Progress& progress) {
  const std::vector<Index> rank_of = ranks(layout, aggregates);
  std::vector<GaugeRounds> chunks(aggregates.block_begin.size() - 1);
  for_blocks(chunks.size(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      chunks[c] = ChunkGauges(layout, aggregates, rank_of)
                      .arrange(aggregates.block_begin[c], aggregates.block_begin[c + 1]);
    }
  });
  GaugeRounds all;
  reserve(all.member, chunks, &GaugeRounds::member);
  reserve(all.round_begin, chunks, &GaugeRounds::round_begin);
  reserve(all.entry, chunks, &GaugeRounds::entry);
  reserve(all.from, chunks, &GaugeRounds::from);
  for (const GaugeRounds& chunk : chunks) {
    const auto first_group = static_cast<Index>(all.member.size() / kLanes);
    for (const SliceRange& range : chunk.ranges) {
      all.ranges.push_back({first_group + range.begin, first_group + range.end});
    }
    all.chunk_begin.push_back(static_cast<Index>(all.ranges.size()));
    append(all.member, chunk.member);
    append_offsets(all.round_begin, chunk.round_begin);
    append(all.entry, chunk.entry);
    append(all.from, chunk.from);
  }
  return all;
}

// ---- Sums --------------------------------------------------------------------------------------

/// The sums of one coarse block.
class BlockSources {
 public:
  BlockSources(const SlicedLayout& fine, const Aggregates& aggregates, const Adjacency& adjacency,
               const SlicedLayout& coarse)
      : fine_(fine),
        aggregates_(aggregates),
        adjacency_(adjacency),
        coarse_(coarse),
        place_of_(fine.slice_count()),
        position_of_(aggregates.count()) {}

  SourceRounds arrange(SliceRange block) {
    rounds_ = {};
    block_ = block;
    collect_runs();
    collect_sources();
    add_rounds();
    deal();
    return std::move(rounds_);
  }

 private:
  std::size_t first_entry() const {
    return std::size_t{coarse_.column_begin[block_.begin]} * kLanes;
  }
  std::size_t entry_count() const {
    return std::size_t{coarse_.column_begin[block_.end]} * kLanes - first_entry();
  }

  template <class Visit>
  void for_each_member(const Visit& visit) const {
    for (Index coarse_slot = block_.begin * kLanes; coarse_slot < block_.end * kLanes;
         ++coarse_slot) {
      const Index a = coarse_.node_at[coarse_slot];
      if (a == kNone) continue;
      for (Index m = aggregates_.begin[a]; m < aggregates_.begin[a + 1]; ++m) {
        visit(coarse_slot, aggregates_.member[m]);
      }
    }
  }

  void collect_runs() {
    std::vector<Index> slices;
    for_each_member([&](Index, Index slot) { slices.push_back(slot / kLanes); });
    ranges::sort(slices.begin(), slices.end());
    slices.erase(std::unique(slices.begin(), slices.end()), slices.end());
    for (const Index slice : slices) {
      place_of_[slice] = static_cast<Index>(rounds_.places);
      rounds_.places +=
          std::size_t{fine_.column_begin[slice + 1] - fine_.column_begin[slice]} * kLanes;
      if (rounds_.runs.empty() || rounds_.runs.back().end != slice) {
        rounds_.runs.push_back({slice, slice});
      }
      rounds_.runs.back().end = slice + 1;
    }
  }

  /// All entries between two aggregates.
  void collect_sources() {
    sources_.clear();
    Index row_of = kNone;
    for_each_member([&](Index coarse_slot, Index slot) {
      const Index aggregate = aggregates_.aggregate[slot];
      if (aggregate != row_of) note_positions(row_of = aggregate);
      const auto row_begin = static_cast<Index>(coarse_.first_entry(coarse_slot) - first_entry());
      const Index slice = slot / kLanes;
      const std::size_t place = place_of_[slice] - std::size_t{fine_.column_begin[slice]} * kLanes;
      std::size_t entry = fine_.first_entry(slot);
      for (Index k = 0; k < fine_.width(slot); ++k, entry += kLanes) {
        const Index other = aggregates_.aggregate[fine_.neighbor[entry]];
        if (other == kNone || other == aggregate) continue;
        sources_.push_back({static_cast<Index>(row_begin + position_of_[other] * kLanes),
                            static_cast<Index>(place + entry)});
      }
    });
  }

  /// The position of each neighbour in the row of an aggregate.
  void note_positions(Index aggregate) {
    Index position = 0;
    for (const Index other : adjacency_.of(aggregate)) position_of_[other] = position++;
  }

  /// A column has as many rounds as its fullest lane has sources.
  void add_rounds() {
    dealt_.assign(entry_count(), 0);
    for (const Source& source : sources_) ++dealt_[source.target];
    rounds_.round_begin.reserve(1 + entry_count() / kLanes);
    for (std::size_t column = 0; column < entry_count(); column += kLanes) {
      Index most = 0;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        most = std::max(most, dealt_[column + lane]);
      }
      rounds_.round_begin.push_back(rounds_.round_begin.back() + most);
    }
  }

  void deal() {
    rounds_.entry.assign(std::size_t{rounds_.round_begin.back()} * kLanes, 0);
    ranges::fill(dealt_, Index{0});
    for (const auto& [target, place] : sources_) {
      const std::size_t round = rounds_.round_begin[target / kLanes] + dealt_[target]++;
      rounds_.entry[round * kLanes + target % kLanes] = place;
    }
  }

  struct Source {
    Index target;  ///< coarse entry, counted from the block's first
    Index place;
  };

  const SlicedLayout& fine_;
  const Aggregates& aggregates_;
  const Adjacency& adjacency_;
  const SlicedLayout& coarse_;
  std::vector<Index> place_of_;     // of a slice's first entry; set for those of this block's runs
  std::vector<Index> position_of_;  // of an aggregate in the row of the current one
  std::vector<Source> sources_;
  std::vector<Index> dealt_;  // sources by coarse entry
  SliceRange block_{};
  SourceRounds rounds_;
};

SourceRounds source_rounds(const SlicedLayout& fine, const Aggregates& aggregates,
                           const Adjacency& adjacency, const SlicedLayout& coarse,
                           const Progress& progress) {
  std::vector<SourceRounds> blocks(coarse.block_count());
  for_blocks(blocks.size(), progress, [&](std::size_t begin, std::size_t end) {
    BlockSources sources(fine, aggregates, adjacency, coarse);
    for (std::size_t b = begin; b < end; ++b) {
      blocks[b] = sources.arrange(coarse.block(static_cast<Index>(b)));
    }
  });
  SourceRounds all;
  reserve(all.round_begin, blocks, &SourceRounds::round_begin);
  reserve(all.entry, blocks, &SourceRounds::entry);
  for (const SourceRounds& block : blocks) {
    all.runs.insert(all.runs.end(), block.runs.begin(), block.runs.end());
    all.run_begin.push_back(static_cast<Index>(all.runs.size()));
    append_offsets(all.round_begin, block.round_begin);
    append(all.entry, block.entry);
    all.places = std::max(all.places, block.places);
  }
  return all;
}

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

std::vector<Index> entries_of_places(const SourceRounds& sources, const SlicedLayout& fine,
                                     Index block) {
  std::vector<Index> entries(kLanes, kNone);
  for (const SliceRange& run : sources.runs_of(block)) {
    for (Index entry = fine.column_begin[run.begin] * kLanes;
         entry < fine.column_begin[run.end] * kLanes; ++entry) {
      entries.push_back(entry);
    }
  }
  return entries;
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
  aggregation.gauges = gauge_rounds(fine, aggregates, progress);
  aggregation.sources = source_rounds(fine, aggregates, adjacency, coarse, progress);
  return aggregation;
}

}  // namespace brindle
