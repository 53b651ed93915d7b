#include "brindle/distributed/levels/rank_graph.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "brindle/base/random.h"

namespace brindle {
namespace {

/// Colours border nodes.
class BorderColorer {
 public:
  BorderColorer(Communicator& ranks, const RankGraph& graph, GreedyColorer& colorer)
      : ranks_(ranks),
        graph_(graph),
        colorer_(colorer),
        border_(border_nodes(graph)),
        owner_(owners(ranks, graph)),
        number_(numbers_on_owners(ranks, graph)) {}

  void run() {
    std::vector<Index> remaining;
    for (Index node = 0; node < graph_.own; ++node) {
      if (border_[node]) remaining.push_back(node);
    }
    while (ranks_.any(!remaining.empty())) {
      for (const Index node : remaining) colorer_.color(node);
      take_ghosts();
      std::erase_if(remaining, [&](Index node) { return !loses(node); });
      for (const Index node : remaining) colorer_.set(node, kUncolored);
    }
  }

 private:
  void take_ghosts() {
    std::vector<Index> colors(graph_.node_count(), kUncolored);
    for (Index node = 0; node < graph_.own; ++node) colors[node] = colorer_.color_of(node);
    exchange(ranks_, graph_.halo, std::span(colors));
    for (Index ghost = graph_.own; ghost < graph_.node_count(); ++ghost) {
      colorer_.set(ghost, colors[ghost]);
    }
  }

  /// Whether a neighbour on another rank has the same colour and takes precedence.
  bool loses(Index node) const {
    for (const Index other : graph_.adjacency->of(node)) {
      if (other < graph_.own || colorer_.color_of(other) != colorer_.color_of(node)) continue;
      if (priority(other) > priority(node)) return true;
    }
    return false;
  }

  std::tuple<std::uint32_t, int, Index> priority(Index node) const {
    const auto rank = static_cast<std::uint32_t>(owner_[node]);
    return {jenkins_hash(number_[node] ^ jenkins_hash(rank)), owner_[node], number_[node]};
  }

  Communicator& ranks_;
  const RankGraph& graph_;
  GreedyColorer& colorer_;
  std::vector<std::uint8_t> border_;
  std::vector<int> owner_;
  std::vector<Index> number_;
};

/// The distinct groups of these nodes, ascending, without kNone.
std::vector<Index> distinct_groups(std::span<const Index> group_of_node) {
  std::vector<Index> result(group_of_node.begin(), group_of_node.end());
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  if (!result.empty() && result.back() == kNone) result.pop_back();
  return result;
}

}  // namespace

std::vector<Index> numbers_on_owners(Communicator& ranks, const RankGraph& graph) {
  std::vector<Index> numbers(graph.node_count());
  std::iota(numbers.begin(), numbers.end(), Index{0});
  exchange(ranks, graph.halo, std::span(numbers));
  return numbers;
}

std::vector<int> owners(const Communicator& ranks, const RankGraph& graph) {
  std::vector<int> result(graph.node_count(), ranks.rank());
  for (const HaloNeighbor& neighbor : graph.halo) {
    std::fill_n(result.begin() + neighbor.first, neighbor.count, neighbor.rank);
  }
  return result;
}

std::vector<std::uint8_t> border_nodes(const RankGraph& graph) {
  std::vector<std::uint8_t> border(graph.own);
  for (const HaloNeighbor& neighbor : graph.halo) {
    for (const Index node : neighbor.sent) border[node] = 1;
  }
  return border;
}

NodeHalo halo_of_groups(Communicator& ranks, const NodeHalo& halo, Index own_groups,
                        std::span<Index> group) {
  exchange(ranks, halo, group);
  NodeHalo result;
  Index first = own_groups;
  for (const HaloNeighbor& neighbor : halo) {
    HaloNeighbor coarse{neighbor.rank, {}, first, 0};
    for (const Index node : neighbor.sent) coarse.sent.push_back(group[node]);
    coarse.sent = distinct_groups(coarse.sent);
    const auto theirs = group.subspan(neighbor.first, neighbor.count);
    const std::vector<Index> ghosts = distinct_groups(theirs);
    for (Index& of_ghost : theirs) {
      if (of_ghost == kNone) continue;
      const auto place = std::ranges::lower_bound(ghosts, of_ghost);
      of_ghost = first + static_cast<Index>(place - ghosts.begin());
    }
    coarse.count = static_cast<Index>(ghosts.size());
    first += coarse.count;
    result.push_back(std::move(coarse));
  }
  return result;
}

Coloring rank_coloring(Communicator& ranks, const RankGraph& graph) {
  GreedyColorer colorer(*graph.adjacency);
  if (ranks.size() > 1) BorderColorer(ranks, graph, colorer).run();
  for (Index node = 0; node < graph.own; ++node) {
    if (colorer.color_of(node) == kUncolored) colorer.color(node);
  }
  Coloring coloring = colorer.take();
  coloring.color_count = ranks.greatest(coloring.color_count);
  return coloring;
}

Coloring with_sorts(const RankGraph& graph, const Coloring& coloring) {
  const std::vector<std::uint8_t> border = border_nodes(graph);
  Coloring result{coloring.color, 3 * coloring.color_count};
  for (Index node = 0; node < graph.node_count(); ++node) {
    if (node >= graph.own) {
      result.color[node] += 2 * coloring.color_count;
    } else if (border[node]) {
      result.color[node] += coloring.color_count;
    }
  }
  return result;
}

}  // namespace brindle
