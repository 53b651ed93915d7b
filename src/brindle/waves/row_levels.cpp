#include "brindle/waves/row_levels.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

constexpr Index kMembers = 4;
constexpr Index kFewestNodes = 32;  ///< that are worth another level
constexpr Index kFree = ~Index{0};

struct StrengthGraph {
  std::vector<Index> offsets;
  std::vector<Index> neighbors;
  std::vector<float> strengths;

  Index size() const { return static_cast<Index>(offsets.size() - 1); }
};

struct Grouping {
  std::vector<Index> parent;
  Index count = 0;
};

/// The free neighbour that the members are joined to most strongly, or kFree. `sums` is all zero
/// before and after.
Index strongest_free(const StrengthGraph& graph, std::span<const Index> members,
                     const Grouping& grouping, std::vector<float>& sums) {
  Index best = kFree;
  for (const Index i : members) {
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
      const Index j = graph.neighbors[e];
      if (grouping.parent[j] != kFree) continue;
      sums[j] += graph.strengths[e];
      if (best == kFree || sums[j] > sums[best]) best = j;
    }
  }
  for (const Index i : members) {
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) sums[graph.neighbors[e]] = 0;
  }
  return best;
}

/// The neighbour's group that a node left alone is joined to most strongly, or kFree.
Index strongest_group(const StrengthGraph& graph, Index node, const Grouping& grouping) {
  Index best = kFree;
  float most = -1;
  for (Index e = graph.offsets[node]; e < graph.offsets[node + 1]; ++e) {
    const Index group = grouping.parent[graph.neighbors[e]];
    if (group == kFree || graph.strengths[e] <= most) continue;
    most = graph.strengths[e];
    best = group;
  }
  return best;
}

/// Nodes left alone join a neighbour's group; only those without neighbours stay alone.
Grouping grouped(const StrengthGraph& graph) {
  Grouping grouping{std::vector<Index>(graph.size(), kFree), 0};
  std::vector<float> sums(graph.size());
  std::vector<Index> members;
  for (Index start = 0; start < graph.size(); ++start) {
    if (grouping.parent[start] != kFree) continue;
    members.assign(1, start);
    grouping.parent[start] = grouping.count;
    while (members.size() < kMembers) {
      const Index next = strongest_free(graph, members, grouping, sums);
      if (next == kFree) break;
      grouping.parent[next] = grouping.count;
      members.push_back(next);
    }
    if (members.size() == 1) {
      grouping.parent[start] = kFree;
      const Index group = strongest_group(graph, start, grouping);
      if (group != kFree) {
        grouping.parent[start] = group;
        continue;
      }
      grouping.parent[start] = grouping.count;
    }
    ++grouping.count;
  }
  return grouping;
}

/// Nodes sorted by a key below `count`, those of one key in their order: where each key's begin.
std::vector<Index> sorted_by(std::span<const Index> key, Index count, std::vector<Index>& nodes) {
  std::vector<Index> begin(count + 1);
  for (const Index k : key) ++begin[k + 1];
  for (Index k = 0; k < count; ++k) begin[k + 1] += begin[k];
  std::vector<Index> next(begin.begin(), begin.end() - 1);
  nodes.resize(key.size());
  for (Index i = 0; i < key.size(); ++i) nodes[next[key[i]]++] = i;
  return begin;
}

StrengthGraph merged(const StrengthGraph& fine, const Grouping& grouping) {
  std::vector<Index> nodes;
  const std::vector<Index> begin = sorted_by(grouping.parent, grouping.count, nodes);
  StrengthGraph coarse{{0}, {}, {}};
  std::vector<Index> entry_of(grouping.count, kFree);
  for (Index group = 0; group < grouping.count; ++group) {
    const std::size_t first = coarse.neighbors.size();
    for (Index n = begin[group]; n < begin[group + 1]; ++n) {
      for (Index e = fine.offsets[nodes[n]]; e < fine.offsets[nodes[n] + 1]; ++e) {
        const Index other = grouping.parent[fine.neighbors[e]];
        if (other == group) continue;
        if (entry_of[other] == kFree || entry_of[other] < first) {
          entry_of[other] = static_cast<Index>(coarse.neighbors.size());
          coarse.neighbors.push_back(other);
          coarse.strengths.push_back(0);
        }
        coarse.strengths[entry_of[other]] += fine.strengths[e];
      }
    }
    coarse.offsets.push_back(static_cast<Index>(coarse.neighbors.size()));
  }
  return coarse;
}

/// Where the nodes of each level lie: those of one parent side by side.
struct Places {
  std::vector<Index> node_at, place_of;
};

Places natural_places(Index count) {
  Places places;
  for (Index i = 0; i < count; ++i) places.node_at.push_back(i);
  places.place_of = places.node_at;
  return places;
}

/// Sets which nodes of `level` are children of which node of the coarser one.
Places placed_by_parents(const Grouping& grouping, const Places& coarse, RowLevel& level) {
  std::vector<Index> parent_place(grouping.parent.size());
  for (std::size_t i = 0; i < parent_place.size(); ++i) {
    parent_place[i] = coarse.place_of[grouping.parent[i]];
  }
  Places places;
  level.children = sorted_by(parent_place, grouping.count, places.node_at);
  places.place_of.resize(parent_place.size());
  level.parent.resize(parent_place.size());
  for (Index place = 0; place < places.node_at.size(); ++place) {
    places.place_of[places.node_at[place]] = place;
    level.parent[place] = parent_place[places.node_at[place]];
  }
  return places;
}

void set_rows(const StrengthGraph& graph, const Places& places, RowLevel& level) {
  level.offsets.resize(graph.offsets.size());
  for (Index place = 0; place < graph.size(); ++place) {
    const Index node = places.node_at[place];
    level.offsets[place + 1] = level.offsets[place] + graph.offsets[node + 1] - graph.offsets[node];
  }
  level.outside.resize(graph.size());
  level.columns.resize(graph.neighbors.size());
  parallel_for(graph.size(), [&](std::size_t begin, std::size_t end) {
    for (auto place = static_cast<Index>(begin); place < end; ++place) {
      const Index node = places.node_at[place], block = place / kRowBlock;
      const auto row = level.columns.begin() + level.offsets[place];
      const auto row_end = level.columns.begin() + level.offsets[place + 1];
      for (Index e = graph.offsets[node]; e < graph.offsets[node + 1]; ++e) {
        row[e - graph.offsets[node]] = places.place_of[graph.neighbors[e]];
      }
      std::sort(row, row_end, [block](Index a, Index b) {
        const bool a_outside = a / kRowBlock != block, b_outside = b / kRowBlock != block;
        return a_outside != b_outside ? b_outside : a < b;
      });
      const auto outside =
          std::find_if(row, row_end, [block](Index column) { return column / kRowBlock != block; });
      level.outside[place] = static_cast<Index>(outside - level.columns.begin());
    }
  });
}

void set_targets(RowLevel& fine, const RowLevel& coarse) {
  fine.target.resize(fine.columns.size());
  // A list as long as the level for each piece.
  const std::size_t grain = std::max<std::size_t>(kParallelGrain, coarse.size() / 8);
  const auto set = [&](std::size_t begin, std::size_t end) {
    std::vector<Index> entry_of(coarse.size());
    for (auto I = static_cast<Index>(begin); I < end; ++I) {
      for (Index e = coarse.offsets[I]; e < coarse.offsets[I + 1]; ++e) {
        entry_of[coarse.columns[e]] = e;
      }
      for (Index e = fine.offsets[fine.children[I]]; e < fine.offsets[fine.children[I + 1]]; ++e) {
        const Index J = fine.parent[fine.columns[e]];
        fine.target[e] = I == J ? kInsideParent : entry_of[J];
      }
    }
  };
  parallel_for(coarse.size(), set, grain);
}

}  // namespace

RowLevels row_levels(const Adjacency& adjacency, std::span<const float> strengths) {
  std::vector<StrengthGraph> graphs = {
      {adjacency.offsets, adjacency.neighbors, {strengths.begin(), strengths.end()}}};
  std::vector<Grouping> groupings;
  while (graphs.back().size() > kFewestNodes) {
    Grouping grouping = grouped(graphs.back());
    if (grouping.count > graphs.back().size() / 10 * 9) break;
    graphs.push_back(merged(graphs.back(), grouping));
    groupings.push_back(std::move(grouping));
  }
  RowLevels result;
  result.levels.resize(graphs.size());
  Places places = natural_places(graphs.back().size());
  for (std::size_t l = graphs.size(); l-- > 0;) {
    RowLevel& level = result.levels[l];
    if (l < groupings.size()) places = placed_by_parents(groupings[l], places, level);
    set_rows(graphs[l], places, level);
    if (l < groupings.size()) set_targets(level, result.levels[l + 1]);
  }
  result.node_at = std::move(places.node_at);
  result.place_of = std::move(places.place_of);
  return result;
}

}  // namespace brindle
