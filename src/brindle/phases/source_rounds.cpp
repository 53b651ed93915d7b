#include "brindle/phases/source_rounds.h"

#include <algorithm>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// Arranges the sums of one coarse block.
class BlockArranger {
 public:
  BlockArranger(const SlicedLayout& fine, const Aggregates& aggregates, const Adjacency& adjacency,
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

  /// Where an aggregate's neighbours stand in its row.
  void note_positions(Index aggregate) {
    Index position = 0;
    for (const Index other : adjacency_.of(aggregate)) position_of_[other] = position++;
  }

  /// As many rounds for every column as its fullest lane has sources.
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
  std::vector<Index> position_of_;  // of an aggregate in the row of the one that is looked at
  std::vector<Source> sources_;
  std::vector<Index> dealt_;  // sources by coarse entry
  SliceRange block_{};
  SourceRounds rounds_;
};

/// Room for all blocks together.
SourceRounds with_room_for(const std::vector<SourceRounds>& blocks) {
  std::size_t runs = 0, rounds = 1, entries = 0;
  for (const SourceRounds& block : blocks) {
    runs += block.runs.size();
    rounds += block.round_begin.size() - 1;
    entries += block.entry.size();
  }
  SourceRounds all;
  all.run_begin.reserve(blocks.size() + 1);
  all.runs.reserve(runs);
  all.round_begin.reserve(rounds);
  all.entry.reserve(entries);
  return all;
}

void append(SourceRounds& all, const SourceRounds& block) {
  const auto first_round = static_cast<Index>(all.entry.size() / kLanes);
  all.runs.insert(all.runs.end(), block.runs.begin(), block.runs.end());
  all.run_begin.push_back(static_cast<Index>(all.runs.size()));
  for (std::size_t c = 1; c < block.round_begin.size(); ++c) {
    all.round_begin.push_back(first_round + block.round_begin[c]);
  }
  all.entry.insert(all.entry.end(), block.entry.begin(), block.entry.end());
  all.places = std::max(all.places, block.places);
}

}  // namespace

SourceRounds source_rounds(const SlicedLayout& fine, const Aggregates& aggregates,
                           const Adjacency& adjacency, const SlicedLayout& coarse,
                           const Progress& progress) {
  std::vector<SourceRounds> blocks(coarse.block_count());
  parallel_for(
      blocks.size(), progress.part(0, 0.8),
      [&](std::size_t begin, std::size_t end) {
        BlockArranger arranger(fine, aggregates, adjacency, coarse);
        for (std::size_t b = begin; b < end; ++b) {
          blocks[b] = arranger.arrange(coarse.block(static_cast<Index>(b)));
        }
      },
      1, kBlocksPerReport);
  progress.report(0.8);
  SourceRounds all = with_room_for(blocks);
  for (const SourceRounds& block : blocks) append(all, block);
  return all;
}

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

}  // namespace brindle
