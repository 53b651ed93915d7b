#include "brindle/phases/aggregation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

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

/// Grows the aggregates of a level one by one.
class Grower {
 public:
  Grower(const SlicedLayout& layout, const SlicedCouplings& couplings)
      : layout_(layout),
        couplings_(couplings),
        inverse_root_degree_(inverse_root_degrees(layout, couplings)) {
    matching_.aggregate.assign(layout.slot_count(), kNone);
    matching_.member.reserve(layout.slot_of.size());
  }

  Matching grow() {
    for (Index slot = 0; slot < layout_.slot_count(); ++slot) {
      if (matching_.aggregate[slot] == kNone && inverse_root_degree_[slot] > 0) grow_from(slot);
    }
    join_left_over();
    return std::move(matching_);
  }

 private:
  struct Candidate {
    Index slot;
    float strength;
  };

  void grow_from(Index seed) {
    candidates_.clear();
    Index next = seed;
    const Index aggregate = matching_.count();
    for (Index size = 0; size < kAggregateSize && next != kNone; ++size) {
      matching_.aggregate[next] = aggregate;
      matching_.member.push_back(next);
      add_candidates(next);
      next = take_strongest();
    }
    if (matching_.member.size() - matching_.begin.back() > 1) {
      matching_.begin.push_back(static_cast<Index>(matching_.member.size()));
      return;
    }
    matching_.member.pop_back();
    matching_.aggregate[seed] = kNone;
    left_over_.push_back(seed);
  }

  /// Adds what the free neighbours of a new member are coupled to it.
  void add_candidates(Index slot) {
    std::size_t entry = layout_.first_entry(slot);
    for (Index k = 0; k < layout_.width(slot); ++k, entry += kLanes) {
      const Index neighbor = layout_.neighbor[entry];
      if (matching_.aggregate[neighbor] != kNone) continue;
      const float s = strength(layout_, couplings_, slot, entry) * inverse_root_degree_[neighbor];
      if (!(s > 0)) continue;
      const auto known = std::ranges::find(candidates_, neighbor, &Candidate::slot);
      if (known == candidates_.end()) {
        candidates_.push_back({neighbor, s});
      } else {
        known->strength += s;
      }
    }
  }

  Index take_strongest() {
    const auto best = std::ranges::max_element(candidates_, {}, &Candidate::strength);
    if (best == candidates_.end()) return kNone;
    const Index slot = best->slot;
    candidates_.erase(best);
    return slot;
  }

  /// All neighbours of a node left over are in aggregates, or it would have grown with one.
  void join_left_over() {
    std::vector<std::pair<Index, Index>> joins;  // aggregate, slot
    for (const Index slot : left_over_) joins.emplace_back(strongest_aggregate(slot), slot);
    std::ranges::stable_sort(joins, {}, &std::pair<Index, Index>::first);
    Matching joined;
    joined.aggregate = std::move(matching_.aggregate);
    joined.member.reserve(matching_.member.size() + joins.size());
    auto join = joins.begin();
    for (Index a = 0; a < matching_.count(); ++a) {
      joined.member.insert(joined.member.end(), matching_.member.begin() + matching_.begin[a],
                           matching_.member.begin() + matching_.begin[a + 1]);
      for (; join != joins.end() && join->first == a; ++join) {
        joined.aggregate[join->second] = a;
        joined.member.push_back(join->second);
      }
      joined.begin.push_back(static_cast<Index>(joined.member.size()));
    }
    matching_ = std::move(joined);
  }

  Index strongest_aggregate(Index slot) const {
    Index best = kNone;
    float best_strength = 0;
    std::size_t entry = layout_.first_entry(slot);
    for (Index k = 0; k < layout_.width(slot); ++k, entry += kLanes) {
      const Index neighbor = layout_.neighbor[entry];
      const float s = strength(layout_, couplings_, slot, entry) * inverse_root_degree_[neighbor];
      if (matching_.aggregate[neighbor] == kNone || !(s > best_strength)) continue;
      best_strength = s;
      best = matching_.aggregate[neighbor];
    }
    return best;
  }

  const SlicedLayout& layout_;
  const SlicedCouplings& couplings_;
  std::vector<float> inverse_root_degree_;
  Matching matching_;
  std::vector<Candidate> candidates_;
  std::vector<Index> left_over_;
};

/// Neighbouring aggregates of one, ascending, into `row`.
void collect_row(const SlicedLayout& layout, const Matching& matching, Index aggregate,
                 std::vector<Index>& row) {
  row.clear();
  for (Index m = matching.begin[aggregate]; m < matching.begin[aggregate + 1]; ++m) {
    const Index slot = matching.member[m];
    std::size_t entry = layout.first_entry(slot);
    for (Index k = 0; k < layout.width(slot); ++k, entry += kLanes) {
      const Index other = matching.aggregate[layout.neighbor[entry]];
      if (other != kNone && other != aggregate) row.push_back(other);
    }
  }
  std::sort(row.begin(), row.end());
  row.erase(std::unique(row.begin(), row.end()), row.end());
}

/// For every fine entry the coarse entry that it adds to; kNone inside aggregates and in filling.
std::vector<Index> coarse_entries(const SlicedLayout& fine, const Matching& matching,
                                  const Adjacency& adjacency, const SlicedLayout& coarse) {
  std::vector<Index> result(fine.entry_count(), kNone);
  parallel_for(fine.slot_count(), [&](std::size_t begin, std::size_t end) {
    for (Index slot = static_cast<Index>(begin); slot < end; ++slot) {
      const Index aggregate = matching.aggregate[slot];
      if (aggregate == kNone) continue;
      const auto row = adjacency.of(aggregate);
      const std::size_t row_begin = coarse.first_entry(coarse.slot_of[aggregate]);
      std::size_t entry = fine.first_entry(slot);
      for (Index k = 0; k < fine.width(slot); ++k, entry += kLanes) {
        const Index other = matching.aggregate[fine.neighbor[entry]];
        if (other == kNone || other == aggregate) continue;
        const auto position = std::ranges::lower_bound(row, other) - row.begin();
        result[entry] = static_cast<Index>(row_begin + position * kLanes);
      }
    }
  });
  return result;
}

/// Sorts fine entries by the coarse entry that they add to, and deals them out in rounds.
SourceRounds source_rounds(const std::vector<Index>& coarse_entry, const SlicedLayout& coarse) {
  std::vector<std::uint16_t> dealt(coarse.entry_count(), 0);
  for (const Index target : coarse_entry) {
    if (target != kNone) ++dealt[target];
  }
  SourceRounds rounds;
  const std::size_t columns = coarse.entry_count() / kLanes;
  rounds.round_begin.assign(columns + 1, 0);
  for (std::size_t column = 0; column < columns; ++column) {
    const auto first = dealt.begin() + static_cast<std::ptrdiff_t>(column * kLanes);
    rounds.round_begin[column + 1] =
        rounds.round_begin[column] + *std::max_element(first, first + kLanes);
  }
  rounds.entry.assign(std::size_t{rounds.round_begin.back()} * kLanes,
                      static_cast<Index>(coarse_entry.size()));
  std::ranges::fill(dealt, std::uint16_t{0});
  for (Index entry = 0; entry < coarse_entry.size(); ++entry) {
    const Index target = coarse_entry[entry];
    if (target == kNone) continue;
    const std::size_t round = rounds.round_begin[target / kLanes] + dealt[target]++;
    rounds.entry[round * kLanes + target % kLanes] = entry;
  }
  return rounds;
}

/// Members in the order of coarse slots.
void arrange_members(Aggregation& aggregation, const Matching& matching,
                     const SlicedLayout& coarse) {
  aggregation.member_begin.assign(1, 0);
  aggregation.member_begin.reserve(coarse.slot_count() + 1);
  aggregation.member.reserve(matching.member.size());
  for (const Index aggregate : coarse.node_at) {
    if (aggregate != kNone) {
      aggregation.member.insert(aggregation.member.end(),
                                matching.member.begin() + matching.begin[aggregate],
                                matching.member.begin() + matching.begin[aggregate + 1]);
    }
    aggregation.member_begin.push_back(static_cast<Index>(aggregation.member.size()));
  }
}

/// Aggregates of a chunk: their rows stay in the second cache from rank to rank.
constexpr Index kChunk = 512;

/// Arranges the gauges of a level, chunk by chunk.
class GaugeArranger {
 public:
  GaugeArranger(const SlicedLayout& layout, const Matching& matching)
      : layout_(layout), matching_(matching), rank_of_(layout.slot_count(), 0) {
    for (Index a = 0; a < matching.count(); ++a) {
      for (Index m = matching.begin[a]; m < matching.begin[a + 1]; ++m) {
        rank_of_[matching.member[m]] = m - matching.begin[a];
      }
    }
  }

  GaugeRounds arrange() {
    for (Index first = 0; first < matching_.count(); first += kChunk) {
      const Index end = std::min(first + kChunk, matching_.count());
      for (Index rank = 1; collect_members(first, end, rank); ++rank) add_range();
      rounds_.chunk_begin.push_back(static_cast<Index>(rounds_.ranges.size()));
    }
    return std::move(rounds_);
  }

 private:
  /// The slots that come `rank`-th in aggregates of a chunk, ascending: couplings are read as they
  /// stand.
  bool collect_members(Index first, Index end, Index rank) {
    members_.clear();
    for (Index a = first; a < end; ++a) {
      const Index m = matching_.begin[a] + rank;
      if (m < matching_.begin[a + 1]) members_.push_back(matching_.member[m]);
    }
    std::ranges::sort(members_);
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
      }
      for (std::size_t e = 0; e < entries_.size(); ++e) {
        rounds_.entry[first + e * kLanes + lane] = entries_[e];
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
      if (matching_.aggregate[j] == matching_.aggregate[slot] && rank_of_[j] < rank_of_[slot]) {
        entries_.push_back(static_cast<Index>(entry));
      }
    }
  }

  const SlicedLayout& layout_;
  const Matching& matching_;
  std::vector<Index> rank_of_;
  std::vector<Index> members_;
  std::vector<Index> entries_;
  GaugeRounds rounds_;
};

}  // namespace

Matching grow_aggregates(const SlicedLayout& layout, const SlicedCouplings& couplings) {
  return Grower(layout, couplings).grow();
}

Adjacency coarse_adjacency(const SlicedLayout& layout, const Matching& matching) {
  Adjacency adjacency;
  adjacency.offsets.reserve(matching.begin.size());
  std::vector<Index> row;
  for (Index aggregate = 0; aggregate < matching.count(); ++aggregate) {
    collect_row(layout, matching, aggregate, row);
    adjacency.neighbors.insert(adjacency.neighbors.end(), row.begin(), row.end());
    adjacency.offsets.push_back(static_cast<Index>(adjacency.neighbors.size()));
  }
  return adjacency;
}

Aggregation arrange(const SlicedLayout& fine, const Matching& matching, const Adjacency& adjacency,
                    const SlicedLayout& coarse) {
  Aggregation aggregation;
  aggregation.sources = source_rounds(coarse_entries(fine, matching, adjacency, coarse), coarse);
  arrange_members(aggregation, matching, coarse);
  aggregation.coarse_slot = matching.aggregate;
  for (Index& slot : aggregation.coarse_slot) {
    slot = slot == kNone ? coarse.slot_count() : coarse.slot_of[slot];
  }
  aggregation.gauges = GaugeArranger(fine, matching).arrange();
  return aggregation;
}

}  // namespace brindle
