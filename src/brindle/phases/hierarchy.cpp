#include "brindle/phases/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"

namespace brindle {
namespace {

/// Coarse slices that one task sums at least.
constexpr std::size_t kSliceGrain = 16;

/// Which aggregate each slot belongs to; aggregates are numbered in the order in which they grew.
struct Matching {
  std::vector<Index> aggregate;  ///< slot -> aggregate or kNone
  std::vector<Index> begin{0};   ///< aggregate a has members begin[a] .. begin[a+1] - 1
  std::vector<Index> member;     ///< slots, in the order in which they joined

  Index count() const { return static_cast<Index>(begin.size()) - 1; }
};

float strength(const Level& level, Index slot, std::size_t entry) {
  const float direct = std::norm(SlicedCouplings::get(level.couplings.direct.get(), entry));
  const float reflecting = std::norm(level.couplings.reflecting_at(slot / kLanes, entry));
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
        degree += std::abs(SlicedCouplings::get(level.couplings.direct.get(), entry)) +
                  std::abs(level.couplings.reflecting_at(slot / kLanes, entry));
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

/// For every fine entry the coarse entry that it adds to.
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

/// Members in the order of coarse slots, and what their gauges hang on.
void arrange_members(Aggregation& aggregation, const Matching& matching, const SlicedLayout& fine,
                     const SlicedLayout& coarse) {
  aggregation.member_begin.assign(1, 0);
  aggregation.member_begin.reserve(coarse.slot_count() + 1);
  aggregation.member.reserve(matching.member.size());
  aggregation.gauge_begin.assign(1, 0);
  aggregation.gauge_begin.reserve(matching.member.size() + 1);
  for (const Index aggregate : coarse.node_at) {
    if (aggregate != kNone) {
      const auto begin = matching.member.begin() + matching.begin[aggregate];
      const auto end = matching.member.begin() + matching.begin[aggregate + 1];
      for (auto member = begin; member != end; ++member) {
        aggregation.member.push_back(*member);
        std::size_t entry = fine.first_entry(*member);
        for (Index k = 0; k < fine.width(*member); ++k, entry += kLanes) {
          if (std::find(begin, member, fine.neighbor[entry]) == member) continue;
          aggregation.gauge_entry.push_back(static_cast<Index>(entry));
        }
        aggregation.gauge_begin.push_back(static_cast<Index>(aggregation.gauge_entry.size()));
      }
    }
    aggregation.member_begin.push_back(static_cast<Index>(aggregation.member.size()));
  }
}

Level make_level(const Adjacency& adjacency) {
  SlicedLayout layout = sliced_layout(adjacency, greedy_coloring(adjacency));
  SlicedCouplings couplings(layout);
  std::vector<Complex> z(layout.slot_count(), kPeak);
  return {std::move(layout), std::move(couplings), {}, {}, std::move(z)};
}

/// Aggregates `fine` and returns the next coarser level, its couplings not yet summed.
Level coarsen(Level& fine) {
  Matching matching = Grower(fine).grow();
  const Adjacency adjacency = coarse_adjacency(fine, matching);
  Level coarse = make_level(adjacency);

  Aggregation& aggregation = fine.aggregation;
  aggregation.coarse_entry = coarse_entries(fine, matching, adjacency, coarse.layout);
  arrange_members(aggregation, matching, fine.layout, coarse.layout);
  aggregation.coarse_slot = std::move(matching.aggregate);
  for (Index& slot : aggregation.coarse_slot) {
    if (slot != kNone) slot = coarse.layout.slot_of[slot];
  }
  fine.gauges.g.assign(fine.layout.slot_count(), Complex(1));
  fine.gauges.conjugated.assign(fine.layout.slot_count(), 0);
  return coarse;
}

/// The gauge of one member: the phase that the earlier members of its aggregate, each in its own
/// gauge, draw it to. The stronger of the two sums decides whether it takes Z or conj(Z).
void renew_gauge(Level& level, Index m) {
  const Aggregation& aggregation = level.aggregation;
  Gauges& gauges = level.gauges;
  const Index slot = aggregation.member[m];
  Complex direct = 0, conjugated = 0;
  for (Index g = aggregation.gauge_begin[m]; g < aggregation.gauge_begin[m + 1]; ++g) {
    const Index entry = aggregation.gauge_entry[g];
    const Index from = level.layout.neighbor[entry];
    const Complex a = SlicedCouplings::get(level.couplings.direct.get(), entry) * gauges.g[from];
    const Complex b =
        level.couplings.reflecting_at(slot / kLanes, entry) * std::conj(gauges.g[from]);
    direct += gauges.conjugated[from] ? b : a;
    conjugated += gauges.conjugated[from] ? a : b;
  }
  const bool takes_conjugate = std::norm(conjugated) > std::norm(direct);
  const Complex sum = takes_conjugate ? conjugated : direct;
  const float length = std::abs(sum);
  gauges.g[slot] = length > 0 ? sum / length : Complex(1);
  gauges.conjugated[slot] = takes_conjugate;
}

/// Adds the couplings of one fine row to the coarse ones, turned into the aggregates' gauges.
void add_row(const Level& fine, Level& coarse, Index coarse_slot, Index slot) {
  const Gauges& gauges = fine.gauges;
  const Index slice = slot / kLanes, coarse_slice = coarse_slot / kLanes;
  const bool conjugated_i = gauges.conjugated[slot] != 0;
  const bool reflects = fine.couplings.slice_reflects[slice] != 0;
  const Complex g_i = std::conj(gauges.g[slot]);
  std::size_t entry = fine.layout.first_entry(slot);
  for (Index k = 0; k < fine.layout.width(slot); ++k, entry += kLanes) {
    const Index target = fine.aggregation.coarse_entry[entry];
    if (target == kNone) continue;
    const Index j = fine.layout.neighbor[entry];
    const bool conjugated_j = gauges.conjugated[j] != 0;
    const auto add = [&](Complex c, bool reflecting) {
      if (conjugated_i) c = std::conj(c);
      if (reflecting == (conjugated_i == conjugated_j)) {
        coarse.couplings.add_reflecting(coarse.layout, coarse_slice, target, c);
      } else {
        SlicedCouplings::add(coarse.couplings.direct.get(), target, c);
      }
    };
    add(g_i * SlicedCouplings::get(fine.couplings.direct.get(), entry) * gauges.g[j], false);
    if (!reflects) continue;
    const Complex b = SlicedCouplings::get(fine.couplings.reflecting.get(), entry);
    if (b != Complex(0)) add(g_i * b * std::conj(gauges.g[j]), true);
  }
}

void add_anchors(const Level& fine, Level& coarse, Index coarse_slot) {
  const Aggregation& aggregation = fine.aggregation;
  Complex sum = 0;
  for (Index m = aggregation.member_begin[coarse_slot];
       m < aggregation.member_begin[coarse_slot + 1]; ++m) {
    const Index slot = aggregation.member[m];
    const Complex t = std::conj(fine.gauges.g[slot]) * fine.couplings.anchor[slot];
    sum += fine.gauges.conjugated[slot] ? std::conj(t) : t;
  }
  coarse.couplings.anchor[coarse_slot] = sum;
}

}  // namespace

Hierarchy build_hierarchy(const PhaseGraph& graph, const Progress& progress) {
  Hierarchy hierarchy;
  Stopwatch watch;
  hierarchy.levels.push_back(make_level(*graph.adjacency));
  hierarchy.topology_milliseconds += watch.lap();
  load_couplings(graph, hierarchy.levels[0].layout, hierarchy.levels[0].couplings);
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
    renew_sums(hierarchy.levels.back(), coarse);
    hierarchy.levels.push_back(std::move(coarse));
    hierarchy.numeric_milliseconds += watch.lap();
  }
  return hierarchy;
}

void renew_gauges(Level& level) {
  const Aggregation& aggregation = level.aggregation;
  parallel_for(aggregation.member_begin.size() - 1, [&](std::size_t begin, std::size_t end) {
    for (Index m = aggregation.member_begin[begin]; m < aggregation.member_begin[end]; ++m) {
      renew_gauge(level, m);
    }
  });
}

void renew_sums(const Level& fine, Level& coarse) {
  const Aggregation& aggregation = fine.aggregation;
  coarse.couplings.anchor.resize(fine.couplings.anchor.empty() ? 0 : coarse.layout.slot_count());
  parallel_for(
      coarse.layout.slice_count(),
      [&](std::size_t begin, std::size_t end) {
        for (Index slice = static_cast<Index>(begin); slice < end; ++slice) {
          coarse.couplings.clear_slice(coarse.layout, slice);
          for (Index slot = slice * kLanes; slot < (slice + 1) * kLanes; ++slot) {
            for (Index m = aggregation.member_begin[slot]; m < aggregation.member_begin[slot + 1];
                 ++m) {
              add_row(fine, coarse, slot, aggregation.member[m]);
            }
            if (!fine.couplings.anchor.empty()) add_anchors(fine, coarse, slot);
          }
        }
      },
      kSliceGrain);
}

void prolong(const Level& coarse, Level& fine) {
  parallel_for(fine.layout.slot_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Index coarse_slot = fine.aggregation.coarse_slot[slot];
      if (coarse_slot == kNone) continue;
      const Complex z = coarse.z[coarse_slot];
      fine.z[slot] = fine.gauges.g[slot] * (fine.gauges.conjugated[slot] ? std::conj(z) : z);
    }
  });
}

}  // namespace brindle
