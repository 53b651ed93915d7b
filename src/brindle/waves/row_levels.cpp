#include "brindle/waves/row_levels.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

constexpr Index kMembers = 4;
constexpr Index kFree = ~Index{0};

/// The free neighbour with the strongest connection to the members, or kFree. `sums` is all zero
/// before and after.
Index strongest_free(const StrengthGraph& graph, std::span<const Index> members,
                     const Grouping& grouping, std::vector<float>& sums) {
  Index best = kFree;
  for (const Index i : members) {
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
      const Index j = graph.neighbors[e];
      if (j >= graph.size() || grouping.parent[j] != kFree) continue;
      sums[j] += graph.strengths[e];
      if (best == kFree || sums[j] > sums[best]) best = j;
    }
  }
  for (const Index i : members) {
    for (Index e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) sums[graph.neighbors[e]] = 0;
  }
  return best;
}

/// The neighbouring group with the strongest connection to a single node, or kFree.
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

}  // namespace

/// Single nodes join a neighbour's group; those without neighbours in their process stay alone.
Grouping RowLevelMaker::grouped(const Progress& progress) const {
  const StrengthGraph& graph = coarsest();
  Grouping grouping{std::vector<Index>(graph.size() + graph.others, kFree), 0, 0};
  std::vector<float> sums(graph.size() + graph.others);
  std::vector<Index> members;
  for (Index start = 0; start < graph.size(); ++start) {
    if (start % kReportSlice == 0) progress.tick();
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

namespace {

/// Nodes grouped by a key below `count`, in ascending order within a group.
CompressedRows<Index> nodes_by(std::span<const Index> key, Index count) {
  return compressed_rows<Index>(count, [&](const auto& add) {
    for (Index i = 0; i < key.size(); ++i) add(key[i], i);
  });
}

StrengthGraph merged(const StrengthGraph& fine, const Grouping& grouping,
                     const Progress& progress) {
  const auto own_parents = std::span(grouping.parent).first(fine.size());
  const CompressedRows<Index> nodes = nodes_by(own_parents, grouping.count);
  StrengthGraph coarse{{0}, {}, {}, grouping.others};
  std::vector<Index> entry_of(grouping.count + grouping.others, kFree);
  for (Index group = 0; group < grouping.count; ++group) {
    if (group % kReportSlice == 0) progress.tick();
    const std::size_t first = coarse.neighbors.size();
    for (const Index node : nodes.of(group)) {
      for (Index e = fine.offsets[node]; e < fine.offsets[node + 1]; ++e) {
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

/// The places of the nodes of a level: those of one parent are adjacent.
struct Places {
  std::vector<Index> node_at, place_of;
};

Places natural_places(Index count) {
  Places places;
  for (Index i = 0; i < count; ++i) places.node_at.push_back(i);
  places.place_of = places.node_at;
  return places;
}

/// Sets parents and children of `level` from the places of the coarser one.
Places placed_by_parents(const Grouping& grouping, const Places& coarse, RowLevel& level) {
  std::vector<Index> parent_place(grouping.parent.size());
  for (std::size_t i = 0; i < parent_place.size(); ++i) {
    parent_place[i] = coarse.place_of[grouping.parent[i]];
  }
  Places places;
  const auto own = std::span(parent_place).first(parent_place.size() - level.others);
  CompressedRows<Index> nodes = nodes_by(own, grouping.count);
  level.children = std::move(nodes.offsets);
  places.node_at = std::move(nodes.entries);
  while (places.node_at.size() < parent_place.size()) {
    places.node_at.push_back(static_cast<Index>(places.node_at.size()));
  }
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
      const auto is_outside = [&graph, block](Index column) {
        return column / kRowBlock != block || column >= graph.size();
      };
      ranges::sort(row, row_end, [&](Index a, Index b) {
        return is_outside(a) != is_outside(b) ? is_outside(b) : a < b;
      });
      const auto outside = std::find_if(row, row_end, is_outside);
      level.outside[place] = static_cast<Index>(outside - level.columns.begin());
    }
  });
}

void set_targets(RowLevel& fine, const RowLevel& coarse) {
  fine.target.resize(fine.columns.size());
  // Tasks are large, because each needs a list as long as the level.
  const std::size_t grain = std::max<std::size_t>(kParallelGrain, coarse.size() / 8);
  const auto set = [&](std::size_t begin, std::size_t end) {
    std::vector<Index> entry_of(coarse.size_with_others());
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

RowLevelMaker::RowLevelMaker(StrengthGraph finest) { graphs_.push_back(std::move(finest)); }

void RowLevelMaker::merge(Grouping grouping, const Progress& progress) {
  graphs_.push_back(merged(graphs_.back(), grouping, progress));
  groupings_.push_back(std::move(grouping));
}

RowLevels RowLevelMaker::made(const Progress& progress) {
  RowLevels result;
  result.levels.resize(graphs_.size());
  places_of_.resize(graphs_.size());
  Places places = natural_places(coarsest().size() + coarsest().others);
  for (std::size_t l = graphs_.size(); l-- > 0;) {
    progress.tick();
    RowLevel& level = result.levels[l];
    level.others = graphs_[l].others;
    if (l < groupings_.size()) places = placed_by_parents(groupings_[l], places, level);
    places_of_[l] = places.place_of;
    progress.tick();
    set_rows(graphs_[l], places, level);
    progress.tick();
    if (l < groupings_.size()) set_targets(level, result.levels[l + 1]);
  }
  result.node_at = std::move(places.node_at);
  result.place_of = std::move(places.place_of);
  return result;
}

RowLevels row_levels(const Adjacency& adjacency, std::span<const float> strengths,
                     const Progress& progress) {
  RowLevelMaker maker(
      {adjacency.offsets, adjacency.neighbors, {strengths.begin(), strengths.end()}});
  while (maker.coarsest().size() > kFewestNodes) {
    Grouping grouping = maker.grouped(progress);
    if (grouping.count > maker.coarsest().size() / 10 * 9) break;
    maker.merge(std::move(grouping), progress);
  }
  return maker.made(progress);
}

}  // namespace brindle
