#include "brindle/phases/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/phases/sliced_kernels.h"

namespace brindle {
namespace {

/// Slices that one task works on at least.
constexpr std::size_t kSliceGrain = 64;

/// Which aggregate each slot belongs to; aggregates are numbered in the order in which they grew.
struct Matching {
  std::vector<Index> aggregate;  ///< slot -> aggregate or kNone
  std::vector<Index> begin{0};   ///< aggregate a has members begin[a] .. begin[a+1] - 1
  std::vector<Index> member;     ///< slots, in the order in which they joined

  Index count() const { return static_cast<Index>(begin.size()) - 1; }
};

float strength(const Level& level, Index slot, std::size_t entry) {
  const float direct = std::norm(level.couplings.direct_at(entry));
  const float reflecting =
      std::norm(level.couplings.reflecting_at(level.layout, slot / kLanes, entry));
  return std::sqrt(std::max(direct, reflecting));
}

/// 1 / sqrt(deg_i), deg_i = sum_j |A_ij| + |B_ij|; zero for nodes without any coupling.
std::vector<float> inverse_root_degrees(const Level& level) {
  std::vector<float> result(level.layout.slot_count());
  parallel_for(result.size(), [&](std::size_t begin, std::size_t end) {
    for (Index slot = static_cast<Index>(begin); slot < end; ++slot) {
      float degree = 0;
      std::size_t entry = level.layout.first_entry(slot);
      for (Index k = 0; k < level.layout.width(slot); ++k, entry += kLanes) {
        degree +=
            std::sqrt(std::norm(level.couplings.direct_at(entry))) +
            std::sqrt(std::norm(level.couplings.reflecting_at(level.layout, slot / kLanes, entry)));
      }
      result[slot] = degree > std::numeric_limits<float>::min() ? 1 / std::sqrt(degree) : 0;
    }
  });
  return result;
}

/// Grows the aggregates of a level one by one.
class Grower {
 public:
  explicit Grower(const Level& level)
      : level_(level), inverse_root_degree_(inverse_root_degrees(level)) {
    matching_.aggregate.assign(level.layout.slot_count(), kNone);
    matching_.member.reserve(level.layout.slot_of.size());
  }

  Matching grow() {
    for (const Index slot : level_.layout.slot_of) {
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
    std::size_t entry = level_.layout.first_entry(slot);
    for (Index k = 0; k < level_.layout.width(slot); ++k, entry += kLanes) {
      const Index neighbor = level_.layout.neighbor[entry];
      if (matching_.aggregate[neighbor] != kNone) continue;
      const float s = strength(level_, slot, entry) * inverse_root_degree_[neighbor];
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
    std::size_t entry = level_.layout.first_entry(slot);
    for (Index k = 0; k < level_.layout.width(slot); ++k, entry += kLanes) {
      const Index neighbor = level_.layout.neighbor[entry];
      const float s = strength(level_, slot, entry) * inverse_root_degree_[neighbor];
      if (matching_.aggregate[neighbor] == kNone || !(s > best_strength)) continue;
      best_strength = s;
      best = matching_.aggregate[neighbor];
    }
    return best;
  }

  const Level& level_;
  std::vector<float> inverse_root_degree_;
  Matching matching_;
  std::vector<Candidate> candidates_;
  std::vector<Index> left_over_;
};

/// Neighbouring aggregates of one, ascending, into `row`.
void collect_row(const Level& level, const Matching& matching, Index aggregate,
                 std::vector<Index>& row) {
  row.clear();
  for (Index m = matching.begin[aggregate]; m < matching.begin[aggregate + 1]; ++m) {
    const Index slot = matching.member[m];
    std::size_t entry = level.layout.first_entry(slot);
    for (Index k = 0; k < level.layout.width(slot); ++k, entry += kLanes) {
      const Index other = matching.aggregate[level.layout.neighbor[entry]];
      if (other != kNone && other != aggregate) row.push_back(other);
    }
  }
  std::sort(row.begin(), row.end());
  row.erase(std::unique(row.begin(), row.end()), row.end());
}

Adjacency coarse_adjacency(const Level& level, const Matching& matching) {
  Adjacency adjacency;
  adjacency.offsets.reserve(matching.begin.size());
  std::vector<Index> row;
  for (Index aggregate = 0; aggregate < matching.count(); ++aggregate) {
    collect_row(level, matching, aggregate, row);
    adjacency.neighbors.insert(adjacency.neighbors.end(), row.begin(), row.end());
    adjacency.offsets.push_back(static_cast<Index>(adjacency.neighbors.size()));
  }
  return adjacency;
}

/// For every fine entry the coarse entry that it adds to; kNone inside aggregates and in filling.
std::vector<Index> coarse_entries(const Level& fine, const Matching& matching,
                                  const Adjacency& adjacency, const SlicedLayout& coarse) {
  std::vector<Index> result(fine.layout.entry_count(), kNone);
  parallel_for(fine.layout.slot_count(), [&](std::size_t begin, std::size_t end) {
    for (Index slot = static_cast<Index>(begin); slot < end; ++slot) {
      const Index aggregate = matching.aggregate[slot];
      if (aggregate == kNone) continue;
      const auto row = adjacency.of(aggregate);
      const std::size_t row_begin = coarse.first_entry(coarse.slot_of[aggregate]);
      std::size_t entry = fine.layout.first_entry(slot);
      for (Index k = 0; k < fine.layout.width(slot); ++k, entry += kLanes) {
        const Index other = matching.aggregate[fine.layout.neighbor[entry]];
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

/// The slots that come `rank`-th in their aggregates.
std::vector<Index> members_of_rank(const Aggregation& aggregation, Index rank) {
  std::vector<Index> members;
  for (std::size_t a = 0; a + 1 < aggregation.member_begin.size(); ++a) {
    const Index m = aggregation.member_begin[a] + rank;
    if (m < aggregation.member_begin[a + 1]) members.push_back(aggregation.member[m]);
  }
  while (members.size() % kLanes != 0) members.push_back(kNone);
  return members;
}

/// Entries in the row of a member that lead to members of its aggregate with a lower rank.
void collect_gauge_entries(const SlicedLayout& layout, const Aggregation& aggregation,
                           const std::vector<Index>& rank_of, Index slot,
                           std::vector<Index>& entries) {
  entries.clear();
  std::size_t entry = layout.first_entry(slot);
  for (Index k = 0; k < layout.width(slot); ++k, entry += kLanes) {
    const Index j = layout.neighbor[entry];
    if (aggregation.coarse_slot[j] == aggregation.coarse_slot[slot] && rank_of[j] < rank_of[slot]) {
      entries.push_back(static_cast<Index>(entry));
    }
  }
}

GaugeRank gauge_rank(const SlicedLayout& layout, const Aggregation& aggregation,
                     const std::vector<Index>& rank_of, std::vector<Index> members) {
  GaugeRank rank;
  rank.member = std::move(members);
  rank.round_begin.assign(1, 0);
  std::vector<Index> entries;
  for (std::size_t group = 0; group < rank.member.size(); group += kLanes) {
    const std::size_t first = rank.entry.size();
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (rank.member[group + lane] == kNone) continue;
      collect_gauge_entries(layout, aggregation, rank_of, rank.member[group + lane], entries);
      if (rank.entry.size() < first + entries.size() * kLanes) {
        rank.entry.resize(first + entries.size() * kLanes, kNone);
      }
      for (std::size_t e = 0; e < entries.size(); ++e) {
        rank.entry[first + e * kLanes + lane] = entries[e];
      }
    }
    rank.round_begin.push_back(static_cast<Index>(rank.entry.size() / kLanes));
  }
  return rank;
}

void arrange_gauges(Aggregation& aggregation, const SlicedLayout& layout) {
  std::vector<Index> rank_of(layout.slot_count(), kNone);
  for (std::size_t a = 0; a + 1 < aggregation.member_begin.size(); ++a) {
    for (Index m = aggregation.member_begin[a]; m < aggregation.member_begin[a + 1]; ++m) {
      rank_of[aggregation.member[m]] = m - aggregation.member_begin[a];
    }
  }
  for (Index rank = 1;; ++rank) {
    std::vector<Index> members = members_of_rank(aggregation, rank);
    if (members.empty()) break;
    aggregation.gauge_ranks.push_back(gauge_rank(layout, aggregation, rank_of, std::move(members)));
  }
}

Level make_level(const Adjacency& adjacency) {
  SlicedLayout layout = sliced_layout(adjacency, greedy_coloring(adjacency));
  SlicedCouplings couplings(layout);
  std::vector<Complex> z(layout.slot_count() + 1, kPeak);
  return {std::move(layout), std::move(couplings), {}, {}, std::move(z)};
}

/// Aggregates `fine` and returns the next coarser level, its couplings not yet summed.
Level coarsen(Level& fine) {
  Matching matching = Grower(fine).grow();
  const Adjacency adjacency = coarse_adjacency(fine, matching);
  Level coarse = make_level(adjacency);

  Aggregation& aggregation = fine.aggregation;
  aggregation.sources =
      source_rounds(coarse_entries(fine, matching, adjacency, coarse.layout), coarse.layout);
  arrange_members(aggregation, matching, coarse.layout);
  aggregation.coarse_slot = std::move(matching.aggregate);
  for (Index& slot : aggregation.coarse_slot) {
    slot = slot == kNone ? coarse.layout.slot_count() : coarse.layout.slot_of[slot];
  }
  arrange_gauges(aggregation, fine.layout);
  fine.gauge.assign(fine.layout.slot_count(), with_conjugate_bit(1, false));
  return coarse;
}

/// The gauge of member m of a rank, its reflecting couplings included: the phase that the earlier
/// members of its aggregate, each in its own gauge, draw it to. The stronger of the two sums
/// decides whether it takes Z or conj(Z).
void gauge_reflecting_member(Level& level, const GaugeRank& rank, std::size_t m) {
  const Index slot = rank.member[m];
  Complex plain = 0, conjugated = 0;
  for (Index round = rank.round_begin[m / kLanes]; round < rank.round_begin[m / kLanes + 1];
       ++round) {
    const Index entry = rank.entry[round * kLanes + m % kLanes];
    if (entry == kNone) continue;
    const Complex from = level.gauge[level.layout.neighbor[entry]];
    const Complex a = level.couplings.direct_at(entry) * from;
    const Complex b =
        level.couplings.reflecting_at(level.layout, slot / kLanes, entry) * std::conj(from);
    plain += conjugate_bit(from) ? b : a;
    conjugated += conjugate_bit(from) ? a : b;
  }
  const float plain_square = std::norm(plain), conjugated_square = std::norm(conjugated);
  const bool takes_conjugate = conjugated_square > plain_square;
  const Complex sum = takes_conjugate ? conjugated : plain;
  const float length = std::sqrt(std::max(plain_square, conjugated_square));
  level.gauge[slot] = with_conjugate_bit(length > 0 ? sum / length : Complex(1), takes_conjugate);
}

void renew_rank(Level& level, const GaugeRank& rank, SliceRange groups) {
  kernels::gauge_members(level.layout, level.couplings, rank.member.data(), rank.round_begin.data(),
                         rank.entry.data(), level.gauge.data(), groups);
  for (std::size_t m = groups.begin * kLanes; m < groups.end * kLanes; ++m) {
    const Index slot = rank.member[m];
    if (slot != kNone && level.couplings.reflecting_count[slot / kLanes] > 0) {
      gauge_reflecting_member(level, rank, m);
    }
  }
}

/// The sums of one coarse slice while it is renewed. Few slices reflect: B is only cleared for
/// those.
class SliceSums {
 public:
  SliceSums(Level& coarse, Index slice)
      : coarse_(coarse),
        slice_(slice),
        first_(std::size_t{coarse.layout.column_begin[slice]} * kLanes),
        end_(std::size_t{coarse.layout.column_begin[slice + 1]} * kLanes) {}

  std::size_t first_entry() const { return first_; }
  std::size_t end_entry() const { return end_; }

  void add_reflecting(std::size_t entry, Complex b) {
    if (!reflects_) buffer().assign(end_ - first_, Complex(0));
    reflects_ = true;
    buffer()[entry - first_] += b;
  }

  void finish() {
    coarse_.couplings.reflecting_count[slice_] = 0;
    if (!reflects_) return;
    for (std::size_t entry = first_; entry < end_; ++entry) {
      const Complex b = buffer()[entry - first_];
      if (b == Complex(0)) continue;
      coarse_.couplings.append_reflecting(coarse_.layout, slice_, {static_cast<Index>(entry), b});
    }
  }

 private:
  static std::vector<Complex>& buffer() {
    thread_local std::vector<Complex> b;
    return b;
  }

  Level& coarse_;
  Index slice_;
  std::size_t first_, end_;
  bool reflects_ = false;
};

/// The direct couplings of the finer level that a gauge has made reflecting.
void sum_marked(const SourceRounds& sources, std::span<const Complex> gauged, SliceSums& sums) {
  for (std::size_t entry = sums.first_entry(); entry < sums.end_entry(); ++entry) {
    const std::size_t column = entry / kLanes;
    for (Index r = sources.round_begin[column]; r < sources.round_begin[column + 1]; ++r) {
      const Complex c = gauged[sources.entry[std::size_t{r} * kLanes + entry % kLanes]];
      if (conjugate_bit(c)) sums.add_reflecting(entry, c);
    }
  }
}

/// Adds the reflecting couplings of one member of the aggregate in `coarse_slot`.
void sum_reflecting(const Level& fine, Index slot, Level& coarse, Index coarse_slot,
                    SliceSums& sums) {
  const Complex g_i = fine.gauge[slot];
  for (const auto& [entry, b] : fine.couplings.reflecting_of(fine.layout, slot / kLanes)) {
    if (entry % kLanes != slot % kLanes) continue;
    const Index j = fine.layout.neighbor[entry];
    const Index neighbor = fine.aggregation.coarse_slot[j];
    if (neighbor == coarse_slot || neighbor == coarse.layout.slot_count()) continue;
    std::size_t target = coarse.layout.first_entry(coarse_slot);
    while (coarse.layout.neighbor[target] != neighbor) target += kLanes;
    const Complex g_j = fine.gauge[j];
    Complex c = std::conj(g_i) * b * std::conj(g_j);
    if (conjugate_bit(g_i)) c = std::conj(c);
    if (conjugate_bit(g_i) == conjugate_bit(g_j)) {
      sums.add_reflecting(target, c);
    } else {
      coarse.couplings.set_direct(target, coarse.couplings.direct_at(target) + c);
    }
  }
}

/// Adds what the kernel leaves out: all that has to do with reflecting couplings.
void finish_slice(const Level& fine, std::span<const Complex> gauged, bool marked, Level& coarse,
                  Index slice) {
  const Aggregation& aggregation = fine.aggregation;
  SliceSums sums(coarse, slice);
  if (marked) sum_marked(aggregation.sources, gauged, sums);
  for (Index slot = slice * kLanes; slot < (slice + 1) * kLanes; ++slot) {
    for (Index m = aggregation.member_begin[slot]; m < aggregation.member_begin[slot + 1]; ++m) {
      if (fine.couplings.reflecting_count[aggregation.member[m] / kLanes] == 0) continue;
      sum_reflecting(fine, aggregation.member[m], coarse, slot, sums);
    }
  }
  sums.finish();
}

void sum_slices(const Level& fine, std::span<const Complex> gauged, Level& coarse,
                SliceRange range) {
  thread_local std::vector<std::uint8_t> marked;
  marked.resize(coarse.layout.slice_count());
  kernels::sum_slices(coarse.layout, fine.aggregation.sources.round_begin.data(),
                      fine.aggregation.sources.entry.data(), gauged.data(),
                      coarse.couplings.direct.get(), marked.data(), range);
  for (Index slice = range.begin; slice < range.end; ++slice) {
    finish_slice(fine, gauged, marked[slice] != 0, coarse, slice);
  }
}

void sum_anchors(const Level& fine, Level& coarse, Index slice) {
  const Aggregation& aggregation = fine.aggregation;
  for (Index slot = slice * kLanes; slot < (slice + 1) * kLanes; ++slot) {
    Complex sum = 0;
    for (Index m = aggregation.member_begin[slot]; m < aggregation.member_begin[slot + 1]; ++m) {
      const Complex g = fine.gauge[aggregation.member[m]];
      const Complex t = std::conj(g) * fine.couplings.anchor[aggregation.member[m]];
      sum += conjugate_bit(g) ? std::conj(t) : t;
    }
    coarse.couplings.anchor[slot] = sum;
  }
}

}  // namespace

Hierarchy build_hierarchy(const PhaseGraph& graph, const Progress& progress) {
  Hierarchy hierarchy;
  Stopwatch watch;
  hierarchy.levels.push_back(make_level(*graph.adjacency));
  hierarchy.topology_milliseconds += watch.lap();
  load_couplings(graph, hierarchy.levels[0].layout, hierarchy.levels[0].couplings);
  std::vector<Complex> gauged(hierarchy.levels[0].layout.entry_count() + 1);
  hierarchy.numeric_milliseconds += watch.lap();
  while (hierarchy.levels.back().layout.entry_count() > 0) {
    progress.report("hierarchy", 1 - static_cast<double>(hierarchy.levels.back().z.size()) /
                                         static_cast<double>(hierarchy.levels[0].z.size()));
    Level coarse = coarsen(hierarchy.levels.back());
    hierarchy.topology_milliseconds += watch.lap();
    if (coarse.layout.slot_count() == 0) {
      hierarchy.levels.back().aggregation = {};
      break;
    }
    renew_gauges(hierarchy.levels.back());
    renew_sums(hierarchy.levels.back(), coarse, gauged);
    hierarchy.levels.push_back(std::move(coarse));
    hierarchy.numeric_milliseconds += watch.lap();
  }
  return hierarchy;
}

void renew_gauges(Level& level) {
  for (const GaugeRank& rank : level.aggregation.gauge_ranks) {
    parallel_for(
        rank.member.size() / kLanes,
        [&](std::size_t begin, std::size_t end) {
          renew_rank(level, rank, {static_cast<Index>(begin), static_cast<Index>(end)});
        },
        kSliceGrain);
  }
}

void renew_sums(const Level& fine, Level& coarse, std::span<Complex> gauged) {
  gauged[fine.layout.entry_count()] = 0;  // what empty places in rounds add
  parallel_for(
      fine.layout.slice_count(),
      [&](std::size_t begin, std::size_t end) {
        kernels::gauge_slices(fine.layout, fine.couplings, fine.gauge.data(), gauged.data(),
                              {static_cast<Index>(begin), static_cast<Index>(end)});
      },
      kSliceGrain);
  coarse.couplings.anchor.resize(fine.couplings.anchor.empty() ? 0 : coarse.layout.slot_count());
  parallel_for(
      coarse.layout.slice_count(),
      [&](std::size_t begin, std::size_t end) {
        sum_slices(fine, gauged, coarse, {static_cast<Index>(begin), static_cast<Index>(end)});
        if (fine.couplings.anchor.empty()) return;
        for (std::size_t slice = begin; slice < end; ++slice) {
          sum_anchors(fine, coarse, static_cast<Index>(slice));
        }
      },
      kSliceGrain);
}

void prolong(const Level& coarse, Level& fine) {
  parallel_for(
      fine.layout.slice_count(),
      [&](std::size_t begin, std::size_t end) {
        kernels::prolong_slices(fine.gauge.data(), fine.aggregation.coarse_slot.data(),
                                coarse.z.data(), fine.z.data(),
                                {static_cast<Index>(begin), static_cast<Index>(end)});
      },
      kSliceGrain);
}

}  // namespace brindle
