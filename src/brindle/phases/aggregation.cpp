#include "brindle/phases/aggregation.h"

#include <algorithm>
#include <utility>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
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

  GaugeSchedule arrange(Index first, Index end) {
    for (Index rank = 1; collect_members(first, end, rank); ++rank) add_range();
    return std::move(rounds_);
  }

 private:
  /// Collects the members of one rank, ascending, so that couplings are read in memory order.
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

  /// Collects the entries of a member's row that lead to lower ranks of its aggregate.
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
  GaugeSchedule rounds_;
};

GaugeSchedule gauge_rounds(const SlicedLayout& layout, const Aggregates& aggregates,
                           const Progress& progress) {
  const std::vector<Index> rank_of = ranks(layout, aggregates);
  std::vector<GaugeSchedule> chunks(aggregates.block_begin.size() - 1);
  for_blocks(chunks.size(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      chunks[c] = ChunkGauges(layout, aggregates, rank_of)
                      .arrange(aggregates.block_begin[c], aggregates.block_begin[c + 1]);
    }
  });
  GaugeSchedule all;
  reserve_for_lists(all.member, chunks, &GaugeSchedule::member);
  reserve_for_lists(all.round_begin, chunks, &GaugeSchedule::round_begin);
  reserve_for_lists(all.entry, chunks, &GaugeSchedule::entry);
  reserve_for_lists(all.from, chunks, &GaugeSchedule::from);
  for (const GaugeSchedule& chunk : chunks) {
    const auto first_group = static_cast<Index>(all.member.size() / kLanes);
    for (const SliceRange& range : chunk.ranges) {
      all.ranges.push_back({first_group + range.begin, first_group + range.end});
    }
    all.chunk_begin.push_back(static_cast<Index>(all.ranges.size()));
    append_list(all.member, chunk.member);
    append_offsets(all.round_begin, chunk.round_begin);
    append_list(all.entry, chunk.entry);
    append_list(all.from, chunk.from);
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

  SumSchedule arrange(SliceRange block) {
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

  /// Collects the entries between different aggregates.
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

  /// Sets the position of each neighbour in the row of an aggregate.
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
  std::vector<Index> place_of_;     // of a slice's first entry; set for slices in this block's runs
  std::vector<Index> position_of_;  // of an aggregate in the current row
  std::vector<Source> sources_;
  std::vector<Index> dealt_;  // sources per coarse entry
  SliceRange block_{};
  SumSchedule rounds_;
};

SumSchedule source_rounds(const SlicedLayout& fine, const Aggregates& aggregates,
                          const Adjacency& adjacency, const SlicedLayout& coarse,
                          const Progress& progress) {
  std::vector<SumSchedule> blocks(coarse.block_count());
  for_blocks(blocks.size(), progress, [&](std::size_t begin, std::size_t end) {
    BlockSources sources(fine, aggregates, adjacency, coarse);
    for (std::size_t b = begin; b < end; ++b) {
      blocks[b] = sources.arrange(coarse.block(static_cast<Index>(b)));
    }
  });
  SumSchedule all;
  reserve_for_lists(all.round_begin, blocks, &SumSchedule::round_begin);
  reserve_for_lists(all.entry, blocks, &SumSchedule::entry);
  for (const SumSchedule& block : blocks) {
    all.runs.insert(all.runs.end(), block.runs.begin(), block.runs.end());
    all.run_begin.push_back(static_cast<Index>(all.runs.size()));
    append_offsets(all.round_begin, block.round_begin);
    append_list(all.entry, block.entry);
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

std::vector<Index> entries_of_places(const SumSchedule& sources, const SlicedLayout& fine,
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
