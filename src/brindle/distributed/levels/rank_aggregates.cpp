#include "brindle/distributed/levels/rank_aggregates.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

namespace brindle {
namespace {

bool has_coupling(const Level& level, Index slot) {
  std::size_t entry = level.layout().first_entry(slot);
  for (Index k = 0; k < level.layout().width(slot); ++k, entry += kLanes) {
    if (level.couplings.direct_at(entry) != Complex(0)) return true;
    if (level.couplings.reflecting_at(level.layout(), slot / kLanes, entry) != Complex(0)) {
      return true;
    }
  }
  return false;
}

/// Appends aggregates of ghosts, which `of_ghost` numbers from the own ones on, for each ghost.
void append_ghosts(const RankGraph& graph, const SlicedLayout& layout,
                   std::span<const Index> of_ghost, Index count, Aggregates& aggregates) {
  const Index own = aggregates.count();
  std::vector<std::vector<Index>> members(count);
  for (Index g = 0; g < of_ghost.size(); ++g) {
    if (of_ghost[g] == kNone) continue;
    const Index slot = layout.slot_of[graph.own + g];
    aggregates.aggregate[slot] = of_ghost[g];
    members[of_ghost[g] - own].push_back(slot);
  }
  for (const std::vector<Index>& slots : members) {
    aggregates.member.insert(aggregates.member.end(), slots.begin(), slots.end());
    aggregates.begin.push_back(static_cast<Index>(aggregates.member.size()));
  }
  aggregates.block_begin.back() = aggregates.count();
}

}  // namespace

Aggregates own_aggregates(const Communicator& ranks, const RankGraph& graph, const Level& level) {
  Aggregates aggregates = grow_aggregates(level.layout(), level.couplings);
  if (ranks.size() == 1) return aggregates;
  for (Index node = 0; node < graph.own; ++node) {
    const Index slot = level.layout().slot_of[node];
    if (aggregates.aggregate[slot] != kNone || !has_coupling(level, slot)) continue;
    aggregates.aggregate[slot] = aggregates.count();
    aggregates.member.push_back(slot);
    aggregates.begin.push_back(static_cast<Index>(aggregates.member.size()));
  }
  aggregates.block_begin.back() = aggregates.count();
  return aggregates;
}

Aggregates planned_aggregates(const SlicedLayout& layout, const PlannedLevel& plan) {
  Aggregates aggregates;
  aggregates.aggregate.assign(layout.slot_count(), kNone);
  aggregates.begin = plan.begin;
  for (const Index node : plan.member) aggregates.member.push_back(layout.slot_of[node]);
  for (Index a = 0; a < aggregates.count(); ++a) {
    for (Index m = plan.begin[a]; m < plan.begin[a + 1]; ++m) {
      aggregates.aggregate[aggregates.member[m]] = a;
    }
  }
  aggregates.block_begin.assign(layout.block_count() + 1, 0);
  for (const Index block : plan.block) ++aggregates.block_begin[block + 1];
  std::partial_sum(aggregates.block_begin.begin(), aggregates.block_begin.end(),
                   aggregates.block_begin.begin());
  return aggregates;
}

RankAggregates with_ghosts(Communicator& ranks, const RankGraph& graph, const Level& level,
                           Aggregates own) {
  const SlicedLayout& layout = level.layout();
  std::vector<Index> aggregate(graph.node_count());
  for (Index node = 0; node < graph.own; ++node) {
    aggregate[node] = own.aggregate[layout.slot_of[node]];
  }

  RankAggregates result;
  result.coarse.own = own.count();
  result.coarse.halo = halo_of_groups(ranks, graph.halo, own.count(), aggregate);
  const auto of_ghost = std::span<const Index>(aggregate).subspan(graph.own);
  Index ghosts = 0;
  for (const HaloNeighbor& neighbor : result.coarse.halo) ghosts += neighbor.count;
  result.aggregates = std::move(own);
  append_ghosts(graph, layout, of_ghost, ghosts, result.aggregates);
  result.coarse.adjacency =
      std::make_shared<const Adjacency>(coarse_adjacency(layout, result.aggregates));
  return result;
}

}  // namespace brindle
