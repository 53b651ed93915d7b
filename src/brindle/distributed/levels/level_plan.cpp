#include "brindle/distributed/levels/level_plan.h"

#include <algorithm>
#include <compare>
#include <memory>
#include <utility>

namespace brindle {
namespace {

/// Where a slot's node ends up: the coarsest one that it is part of.
struct Root {
  std::size_t level;
  Index slot;
  auto operator<=>(const Root&) const = default;
};

/// Cuts levels for ranks. All is by slot of a level unless said otherwise.
class LevelCutter {
 public:
  LevelCutter(const Hierarchy& hierarchy, std::size_t last, std::span<const RowPlaces> places)
      : levels_(std::span(hierarchy.levels).first(last + 1)),
        places_(places),
        owner_(levels_.size()),
        node_(levels_.size()),
        own_(levels_.size(), std::vector<std::vector<Index>>(places.size())) {
    find_owners();
    for (std::size_t l = 0; l < levels_.size(); ++l) {
      number_nodes(l);
      colors_.push_back(colors_of(levels_[l].layout()));
      blocks_.push_back(blocks_of(levels_[l].layout()));
    }
    find_sources();
  }

  CutLevels cut() const {
    CutLevels result;
    for (std::size_t r = 0; r < places_.size(); ++r) {
      LevelPlan& plan = result.plans.emplace_back();
      for (std::size_t l = 0; l < levels_.size(); ++l) plan.levels.push_back(planned(l, r));
      add_rows(r, plan);
      for (const Index slot : own_.back()[r]) {
        result.number_of.push_back(levels_.back().layout().node_at[slot]);
      }
    }
    return result;
  }

 private:
  bool is_last(std::size_t level) const { return level + 1 == levels_.size(); }

  /// The slot in the next level; none where it has no aggregate.
  Index parent(std::size_t level, Index slot) const {
    if (is_last(level)) return kNone;
    const Index coarse = levels_[level].aggregation().coarse_slot[slot];
    return coarse < levels_[level + 1].layout().slot_count() ? coarse : kNone;
  }

  Root root_of(Index slot) const {
    Root root{0, slot};
    for (Index next = parent(0, slot); next != kNone; next = parent(root.level, next)) {
      root = {root.level + 1, next};
    }
    return root;
  }

  void find_owners() {
    std::vector<std::pair<Root, Index>> votes;
    for (std::size_t r = 0; r < places_.size(); ++r) {
      for (const Index slot : places_[r].slot) {
        votes.emplace_back(root_of(slot), static_cast<Index>(r));
      }
    }
    std::ranges::sort(votes);
    for (std::size_t l = 0; l < levels_.size(); ++l) {
      owner_[l].assign(levels_[l].layout().slot_count(), kNone);
    }
    for (auto vote = votes.begin(); vote != votes.end();) {
      const auto end = std::find_if(vote, votes.end(),
                                    [&](const auto& other) { return other.first != vote->first; });
      owner_[vote->first.level][vote->first.slot] = most_frequent(vote, end);
      vote = end;
    }
    for (std::size_t l = levels_.size() - 1; l-- > 0;) {
      for (Index slot = 0; slot < owner_[l].size(); ++slot) {
        const Index coarse = parent(l, slot);
        if (coarse != kNone) owner_[l][slot] = owner_[l + 1][coarse];
      }
    }
  }

  /// The rank with most of these votes, which are in the order of ranks; the lowest of several.
  template <class Vote>
  static Index most_frequent(Vote vote, Vote end) {
    Index best = vote->second;
    std::ptrdiff_t most = 0;
    while (vote != end) {
      const auto next =
          std::find_if(vote, end, [&](const auto& other) { return other.second != vote->second; });
      if (next - vote > most) {
        most = next - vote;
        best = vote->second;
      }
      vote = next;
    }
    return best;
  }

  /// Ranks have their nodes block by block: as the finest level has its slots, and coarser ones the
  /// numbers of aggregates.
  void number_nodes(std::size_t level) {
    const SlicedLayout& layout = levels_[level].layout();
    const auto add = [&](Index slot) {
      if (slot == kNone || owner_[level][slot] == kNone) return;
      std::vector<Index>& own = own_[level][owner_[level][slot]];
      node_[level][slot] = static_cast<Index>(own.size());
      own.push_back(slot);
    };
    node_[level].assign(layout.slot_count(), kNone);
    if (level > 0) {
      for (const Index slot : layout.slot_of) add(slot);
      return;
    }
    for (Index slot = 0; slot < layout.slot_count(); ++slot) add(slot);
  }

  PlannedLevel planned(std::size_t level, std::size_t rank) const {
    const SlicedLayout& layout = levels_[level].layout();
    PlannedLevel plan;
    plan.color_count = layout.color_count();
    plan.slots_of_all = layout.slot_count();
    const std::vector<Index>&colors = colors_[level], &blocks = blocks_[level];
    const std::vector<Index>& own = own_[level][rank];
    std::vector<Index> block_of_node;
    for (std::size_t n = 0; n < own.size(); ++n) {
      plan.color.push_back(colors[own[n]]);
      plan.number.push_back(layout.node_at[own[n]]);
      const Index block = blocks[own[n] / kLanes];
      if (n > 0 && block != blocks[own[n - 1] / kLanes]) {
        plan.block_end.push_back(static_cast<Index>(n));
      }
      block_of_node.push_back(static_cast<Index>(plan.block_end.size()));
    }
    if (!own.empty()) plan.block_end.push_back(static_cast<Index>(own.size()));
    if (!is_last(level)) add_aggregates(level, rank, block_of_node, plan);
    return plan;
  }

  void add_aggregates(std::size_t level, std::size_t rank, const std::vector<Index>& block_of_node,
                      PlannedLevel& plan) const {
    const Aggregation& aggregation = levels_[level].aggregation();
    Index block = 0;
    for (const Index coarse : own_[level + 1][rank]) {
      for (Index m = aggregation.member_begin[coarse]; m < aggregation.member_begin[coarse + 1];
           ++m) {
        plan.member.push_back(node_[level][aggregation.member[m]]);
      }
      block = std::max(block, block_of_node[plan.member[plan.begin.back()]]);
      plan.begin.push_back(static_cast<Index>(plan.member.size()));
      plan.block.push_back(block);
    }
  }

  void add_rows(std::size_t rank, LevelPlan& plan) const {
    const SlicedLayout& layout = levels_[0].layout();
    for (const Index slot : own_[0][rank]) {
      const RowPlaces& places = places_[source_rank_[slot]];
      const Index row = source_row_[slot];
      plan.source_rank.push_back(source_rank_[slot]);
      plan.source_node.push_back(row);
      for (Index e = places.edge_begin[row]; e < places.edge_begin[row + 1]; ++e) {
        const Index neighbor = layout.neighbor[places.entry[e]];
        plan.neighbor_rank.push_back(owner_[0][neighbor]);
        plan.neighbor_node.push_back(node_[0][neighbor]);
        plan.neighbor_number.push_back(layout.node_at[neighbor]);
      }
      plan.row_begin.push_back(static_cast<Index>(plan.neighbor_rank.size()));
    }
  }

  void find_sources() {
    source_rank_.assign(levels_[0].layout().slot_count(), kNone);
    source_row_ = source_rank_;
    for (std::size_t r = 0; r < places_.size(); ++r) {
      for (Index n = 0; n < places_[r].slot.size(); ++n) {
        source_rank_[places_[r].slot[n]] = static_cast<Index>(r);
        source_row_[places_[r].slot[n]] = n;
      }
    }
  }

  static std::vector<Index> colors_of(const SlicedLayout& layout) {
    std::vector<Index> colors(layout.slot_count());
    for (Index color = 0; color < layout.color_count(); ++color) {
      for (const SliceRange& range : layout.ranges_of(color)) {
        std::fill(colors.begin() + range.begin * kLanes, colors.begin() + range.end * kLanes,
                  color);
      }
    }
    return colors;
  }

  /// By slice.
  static std::vector<Index> blocks_of(const SlicedLayout& layout) {
    std::vector<Index> blocks(layout.slice_count());
    for (Index b = 0; b < layout.block_count(); ++b) {
      std::fill(blocks.begin() + layout.block(b).begin, blocks.begin() + layout.block(b).end, b);
    }
    return blocks;
  }

  std::span<const Level> levels_;
  std::span<const RowPlaces> places_;
  std::vector<std::vector<Index>> colors_, blocks_;  ///< by level; blocks by slice
  /// The ranks that have the finest level's rows, and which of theirs they are.
  std::vector<Index> source_rank_, source_row_;
  std::vector<std::vector<Index>> owner_;             ///< by level
  std::vector<std::vector<Index>> node_;              ///< by level: the owner's number
  std::vector<std::vector<std::vector<Index>>> own_;  ///< slots by level and rank
};

using Lists = std::vector<std::vector<Index>*>;

/// All lists of a plan, in one order.
Lists lists_of(LevelPlan& plan) {
  Lists lists = {&plan.source_rank,   &plan.source_node,   &plan.row_begin,
                 &plan.neighbor_rank, &plan.neighbor_node, &plan.neighbor_number};
  for (PlannedLevel& level : plan.levels) {
    for (auto* list : {&level.color, &level.number, &level.block_end, &level.begin, &level.member,
                       &level.block}) {
      lists.push_back(list);
    }
  }
  return lists;
}

std::vector<Index> packed(LevelPlan plan) {
  std::vector<Index> words = {static_cast<Index>(plan.levels.size())};
  for (const PlannedLevel& level : plan.levels) {
    words.insert(words.end(), {level.color_count, level.slots_of_all});
  }
  for (const std::vector<Index>* list : lists_of(plan)) {
    words.push_back(static_cast<Index>(list->size()));
    words.insert(words.end(), list->begin(), list->end());
  }
  return words;
}

LevelPlan unpacked(std::span<const Index> words) {
  const auto next = [&] {
    const Index word = words.front();
    words = words.subspan(1);
    return word;
  };
  LevelPlan plan;
  plan.levels.resize(next());
  for (PlannedLevel& level : plan.levels) {
    level.color_count = next();
    level.slots_of_all = next();
  }
  for (std::vector<Index>* list : lists_of(plan)) {
    const Index count = next();
    list->assign(words.begin(), words.begin() + count);
    words = words.subspan(count);
  }
  return plan;
}

using NodeOfRank = std::pair<Index, Index>;  // rank, node there

/// The neighbours that other ranks own, in their order.
std::vector<NodeOfRank> ghosts_of(const LevelPlan& plan, Index rank) {
  std::vector<NodeOfRank> ghosts;
  for (std::size_t e = 0; e < plan.neighbor_rank.size(); ++e) {
    if (plan.neighbor_rank[e] != rank) {
      ghosts.emplace_back(plan.neighbor_rank[e], plan.neighbor_node[e]);
    }
  }
  std::ranges::sort(ghosts);
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  return ghosts;
}

/// By rank: own nodes with a neighbour there, ascending.
std::vector<std::vector<Index>> nodes_beside(const LevelPlan& plan, std::size_t ranks) {
  std::vector<std::vector<Index>> nodes(ranks);
  for (Index node = 0; node + 1 < plan.row_begin.size(); ++node) {
    for (Index e = plan.row_begin[node]; e < plan.row_begin[node + 1]; ++e) {
      std::vector<Index>& of_rank = nodes[plan.neighbor_rank[e]];
      if (of_rank.empty() || of_rank.back() != node) of_rank.push_back(node);
    }
  }
  return nodes;
}

/// The planned rows in the order of the neighbours' numbers in the whole.
Adjacency rows_in_order(const LevelPlan& plan, std::span<const Index> neighbor,
                        std::size_t ghosts) {
  Adjacency adjacency;
  std::vector<std::pair<Index, Index>> row;  // number, node
  for (std::size_t node = 0; node + 1 < plan.row_begin.size(); ++node) {
    row.clear();
    for (Index e = plan.row_begin[node]; e < plan.row_begin[node + 1]; ++e) {
      row.emplace_back(plan.neighbor_number[e], neighbor[e]);
    }
    std::ranges::sort(row);
    for (const auto& entry : row) adjacency.neighbors.push_back(entry.second);
    adjacency.offsets.push_back(static_cast<Index>(adjacency.neighbors.size()));
  }
  adjacency.offsets.resize(adjacency.offsets.size() + ghosts, adjacency.offsets.back());
  return adjacency;
}

}  // namespace

CutLevels cut_levels(const Hierarchy& hierarchy, std::size_t last,
                     std::span<const RowPlaces> places) {
  return LevelCutter(hierarchy, last, places).cut();
}

LevelPlan scatter_plans(Communicator& ranks, std::span<const LevelPlan> plans) {
  std::vector<std::vector<Index>> lists(static_cast<std::size_t>(ranks.size()));
  for (std::size_t r = 0; r < plans.size(); ++r) lists[r] = packed(plans[r]);
  return unpacked(ranks.swap_lists(lists)[0]);
}

PlannedGraph graph_of(const LevelPlan& plan, const Communicator& ranks) {
  const auto rank = static_cast<Index>(ranks.rank());
  const std::vector<NodeOfRank> ghosts = ghosts_of(plan, rank);
  PlannedGraph planned;
  RankGraph& graph = planned.graph;
  graph.own = static_cast<Index>(plan.source_node.size());
  for (std::size_t e = 0; e < plan.neighbor_rank.size(); ++e) {
    const NodeOfRank neighbor{plan.neighbor_rank[e], plan.neighbor_node[e]};
    const auto ghost = std::ranges::lower_bound(ghosts, neighbor) - ghosts.begin();
    planned.neighbor.push_back(neighbor.first == rank ? neighbor.second
                                                      : graph.own + static_cast<Index>(ghost));
  }
  const auto beside = nodes_beside(plan, static_cast<std::size_t>(ranks.size()));
  for (auto first = ghosts.begin(); first != ghosts.end();) {
    const auto end = std::find_if(
        first, ghosts.end(), [&](const NodeOfRank& ghost) { return ghost.first != first->first; });
    graph.halo.push_back({static_cast<int>(first->first), beside[first->first],
                          graph.own + static_cast<Index>(first - ghosts.begin()),
                          static_cast<Index>(end - first)});
    first = end;
  }
  graph.adjacency =
      std::make_shared<const Adjacency>(rows_in_order(plan, planned.neighbor, ghosts.size()));
  return planned;
}

void order_rows(Communicator& ranks, const PlannedLevel& plan, RankGraph& graph) {
  std::vector<Index> number = plan.number;
  number.resize(graph.node_count());
  exchange(ranks, graph.halo, std::span(number));
  Adjacency ordered = *graph.adjacency;
  for (Index node = 0; node < graph.own; ++node) {
    std::sort(ordered.neighbors.begin() + ordered.offsets[node],
              ordered.neighbors.begin() + ordered.offsets[node + 1],
              [&](Index a, Index b) { return number[a] < number[b]; });
  }
  graph.adjacency = std::make_shared<const Adjacency>(std::move(ordered));
}

}  // namespace brindle
