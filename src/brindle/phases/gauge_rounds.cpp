#include "brindle/phases/gauge_rounds.h"

#include <algorithm>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// Place of every slot in its aggregate.
std::vector<Index> ranks(const SlicedLayout& layout, const Aggregates& aggregates) {
  std::vector<Index> rank_of(layout.slot_count(), 0);
  for (Index a = 0; a < aggregates.count(); ++a) {
    for (Index m = aggregates.begin[a]; m < aggregates.begin[a + 1]; ++m) {
      rank_of[aggregates.member[m]] = m - aggregates.begin[a];
    }
  }
  return rank_of;
}

/// Arranges the gauges of one chunk.
class ChunkArranger {
 public:
  ChunkArranger(const SlicedLayout& layout, const Aggregates& aggregates,
                const std::vector<Index>& rank_of)
      : layout_(layout), aggregates_(aggregates), rank_of_(rank_of) {}

  GaugeRounds arrange(Index first, Index end) {
    for (Index rank = 1; collect_members(first, end, rank); ++rank) add_range();
    return std::move(rounds_);
  }

 private:
  /// The slots that come `rank`-th in aggregates of a chunk, ascending: couplings are read as they
  /// stand.
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

/// Room for all chunks together.
GaugeRounds with_room_for(const std::vector<GaugeRounds>& chunks) {
  std::size_t members = 0, rounds = 1, entries = 0;
  for (const GaugeRounds& chunk : chunks) {
    members += chunk.member.size();
    rounds += chunk.round_begin.size() - 1;
    entries += chunk.entry.size();
  }
  GaugeRounds all;
  all.member.reserve(members);
  all.round_begin.reserve(rounds);
  all.entry.reserve(entries);
  all.from.reserve(entries);
  return all;
}

void append(GaugeRounds& all, const GaugeRounds& chunk) {
  const auto first_group = static_cast<Index>(all.member.size() / kLanes);
  const auto first_round = static_cast<Index>(all.entry.size() / kLanes);
  for (const SliceRange& range : chunk.ranges) {
    all.ranges.push_back({first_group + range.begin, first_group + range.end});
  }
  all.member.insert(all.member.end(), chunk.member.begin(), chunk.member.end());
  for (std::size_t g = 1; g < chunk.round_begin.size(); ++g) {
    all.round_begin.push_back(first_round + chunk.round_begin[g]);
  }
  all.entry.insert(all.entry.end(), chunk.entry.begin(), chunk.entry.end());
  all.from.insert(all.from.end(), chunk.from.begin(), chunk.from.end());
  all.chunk_begin.push_back(static_cast<Index>(all.ranges.size()));
}

}  // namespace

GaugeRounds gauge_rounds(const SlicedLayout& layout, const Aggregates& aggregates,
                         const Progress& progress) {
  const std::vector<Index> rank_of = ranks(layout, aggregates);
  std::vector<GaugeRounds> chunks(aggregates.block_begin.size() - 1);
  parallel_for(
      chunks.size(), progress.part(0, 0.7),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
          chunks[c] = ChunkArranger(layout, aggregates, rank_of)
                          .arrange(aggregates.block_begin[c], aggregates.block_begin[c + 1]);
        }
      },
      1, kBlocksPerReport);
  progress.report(0.7);
  GaugeRounds all = with_room_for(chunks);
  for (const GaugeRounds& chunk : chunks) append(all, chunk);
  return all;
}

}  // namespace brindle
