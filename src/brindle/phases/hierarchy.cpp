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

/// Which aggregate each slot belongs to; aggregates are numbered in the order of node numbers.
struct Matching {
  std::vector<Index> aggregate;    ///< slot -> aggregate or kNone
  std::vector<Index> gauge_entry;  ///< as in Aggregation
  Index count = 0;
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

struct Strongest {
  Index slot = kNone;
  Index entry = kNone;
};

/// The neighbour of `slot` with the strongest normalised coupling among those that `admits`.
template <class Admits>
Strongest strongest_neighbor(const Level& level, const std::vector<float>& inverse_root_degree,
                             Index slot, const Admits& admits) {
  Strongest best;
  float best_strength = 0;
  std::size_t entry = level.layout.first_entry(slot);
  for (Index k = 0; k < level.layout.width(slot); ++k, entry += kLanes) {
    const Index neighbor = level.layout.neighbor[entry];
    if (neighbor == slot || !admits(neighbor)) continue;
    const float s = strength(level, slot, entry) * inverse_root_degree[neighbor];
    if (s > best_strength) {
      best_strength = s;
      best = {neighbor, static_cast<Index>(entry)};
    }
  }
  return best;
}

/// The entry in the row of `slot` that leads to `neighbor`.
Index entry_to(const SlicedLayout& layout, Index slot, Index neighbor) {
  std::size_t entry = layout.first_entry(slot);
  while (layout.neighbor[entry] != neighbor) entry += kLanes;
  return static_cast<Index>(entry);
}

Matching match(const Level& level) {
  const SlicedLayout& layout = level.layout;
  const std::vector<float> inverse_root_degree = inverse_root_degrees(level);
  Matching matching{std::vector<Index>(layout.slot_count(), kNone),
                    std::vector<Index>(layout.slot_count(), kNone), 0};
  std::vector<Index> left_over;
  for (const Index slot : layout.slot_of) {
    if (matching.aggregate[slot] != kNone || inverse_root_degree[slot] == 0) continue;
    const auto partner = strongest_neighbor(level, inverse_root_degree, slot, [&](Index other) {
      return matching.aggregate[other] == kNone;
    });
    if (partner.slot == kNone) {
      left_over.push_back(slot);
      continue;
    }
    matching.aggregate[slot] = matching.aggregate[partner.slot] = matching.count++;
    matching.gauge_entry[partner.slot] = entry_to(layout, partner.slot, slot);
  }
  // All neighbours of a node left over are paired, or it would have been paired with one.
  const std::vector<Index> paired = matching.aggregate;
  for (const Index slot : left_over) {
    const auto host = strongest_neighbor(level, inverse_root_degree, slot,
                                         [&](Index other) { return paired[other] != kNone; });
    matching.aggregate[slot] = paired[host.slot];
    matching.gauge_entry[slot] = host.entry;
  }
  return matching;
}

/// Members by aggregate, in an order in which every gauge hangs on a member before it.
struct Members {
  std::vector<Index> begin;
  std::vector<Index> slot;
};

Members members_of(const Matching& matching, const SlicedLayout& layout) {
  Members members{std::vector<Index>(matching.count + 1, 0), {}};
  for (const Index slot : layout.slot_of) {
    if (matching.aggregate[slot] != kNone) ++members.begin[matching.aggregate[slot] + 1];
  }
  for (Index a = 0; a < matching.count; ++a) members.begin[a + 1] += members.begin[a];
  members.slot.resize(members.begin.back());
  std::vector<Index> end(members.begin.begin(), members.begin.end() - 1);
  // First references, then those that hang on a reference, then those that hang on these.
  const auto depth = [&](Index slot) {
    const Index entry = matching.gauge_entry[slot];
    if (entry == kNone) return 0;
    return matching.gauge_entry[layout.neighbor[entry]] == kNone ? 1 : 2;
  };
  for (int pass = 0; pass < 3; ++pass) {
    for (const Index slot : layout.slot_of) {
      const Index aggregate = matching.aggregate[slot];
      if (aggregate != kNone && depth(slot) == pass) members.slot[end[aggregate]++] = slot;
    }
  }
  return members;
}

/// Neighbouring aggregates of one, ascending, into `row`.
void collect_row(const Level& level, const Matching& matching, const Members& members,
                 Index aggregate, std::vector<Index>& row) {
  row.clear();
  for (Index m = members.begin[aggregate]; m < members.begin[aggregate + 1]; ++m) {
    const Index slot = members.slot[m];
    std::size_t entry = level.layout.first_entry(slot);
    for (Index k = 0; k < level.layout.width(slot); ++k, entry += kLanes) {
      const Index other = matching.aggregate[level.layout.neighbor[entry]];
      if (other != kNone && other != aggregate) row.push_back(other);
    }
  }
  std::sort(row.begin(), row.end());
  row.erase(std::unique(row.begin(), row.end()), row.end());
}

Adjacency coarse_adjacency(const Level& level, const Matching& matching, const Members& members) {
  Adjacency adjacency;
  adjacency.offsets.reserve(matching.count + 1);
  std::vector<Index> row;
  for (Index aggregate = 0; aggregate < matching.count; ++aggregate) {
    collect_row(level, matching, members, aggregate, row);
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

/// Members in the order of coarse slots.
void arrange_members(Aggregation& aggregation, const Members& members, const SlicedLayout& coarse) {
  aggregation.member_begin.assign(1, 0);
  aggregation.member_begin.reserve(coarse.slot_count() + 1);
  aggregation.member.reserve(members.slot.size());
  for (const Index aggregate : coarse.node_at) {
    if (aggregate != kNone) {
      aggregation.member.insert(aggregation.member.end(),
                                members.slot.begin() + members.begin[aggregate],
                                members.slot.begin() + members.begin[aggregate + 1]);
    }
    aggregation.member_begin.push_back(static_cast<Index>(aggregation.member.size()));
  }
}

Level make_level(const Adjacency& adjacency) {
  SlicedLayout layout = sliced_layout(adjacency, greedy_coloring(adjacency));
  SlicedCouplings couplings(layout);
  std::vector<Complex> z(layout.slot_count(), Complex(1));
  return {std::move(layout), std::move(couplings), {}, {}, std::move(z)};
}

/// Aggregates `fine` and returns the next coarser level, its couplings not yet summed.
Level coarsen(Level& fine) {
  Matching matching = match(fine);
  const Members members = members_of(matching, fine.layout);
  const Adjacency adjacency = coarse_adjacency(fine, matching, members);
  Level coarse = make_level(adjacency);

  Aggregation& aggregation = fine.aggregation;
  aggregation.coarse_entry = coarse_entries(fine, matching, adjacency, coarse.layout);
  arrange_members(aggregation, members, coarse.layout);
  aggregation.gauge_entry = std::move(matching.gauge_entry);
  aggregation.coarse_slot = std::move(matching.aggregate);
  for (Index& slot : aggregation.coarse_slot) {
    if (slot != kNone) slot = coarse.layout.slot_of[slot];
  }
  fine.gauges.g.assign(fine.layout.slot_count(), Complex(1));
  fine.gauges.conjugated.assign(fine.layout.slot_count(), 0);
  return coarse;
}

/// The gauge of one member from the already gauged one that it hangs on: the stronger of its two
/// couplings decides whether the wave is passed on or reflected.
void renew_gauge(Level& level, Index slot) {
  const Index entry = level.aggregation.gauge_entry[slot];
  Gauges& gauges = level.gauges;
  if (entry == kNone) {
    gauges.g[slot] = 1;
    gauges.conjugated[slot] = 0;
    return;
  }
  const Index from = level.layout.neighbor[entry];
  const Complex a = SlicedCouplings::get(level.couplings.direct.get(), entry);
  const Complex b = level.couplings.reflecting_at(slot / kLanes, entry);
  const bool reflects = std::norm(b) > std::norm(a);
  const Complex product = reflects ? b * std::conj(gauges.g[from]) : a * gauges.g[from];
  const float length = std::abs(product);
  gauges.g[slot] = length > 0 ? product / length : Complex(1);
  gauges.conjugated[slot] = gauges.conjugated[from] ^ static_cast<std::uint8_t>(reflects);
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
      renew_gauge(level, aggregation.member[m]);
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
