#include "brindle/distributed/gathered_levels.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "brindle/phases/multilevel.h"

namespace brindle {
namespace {

/// The neighbours of gathered nodes, rank by rank as the ranks have them.
struct GatheredRows {
  std::vector<Index> begin{0};
  std::vector<Index> neighbors;

  std::span<const Index> of(Index node) const {
    return std::span(neighbors).subspan(begin[node], begin[node + 1] - begin[node]);
  }
  Index count() const { return static_cast<Index>(begin.size()) - 1; }
};

/// On rank 0; nothing elsewhere. Nodes are numbered rank by rank from `first_node`.
GatheredRows gather_rows(Communicator& ranks, const RankGraph& graph,
                         std::span<const Index> first_node) {
  const std::vector<int> owner = owners(ranks, graph);
  std::vector<Index> number = numbers_on_owners(ranks, graph);
  for (Index node = 0; node < number.size(); ++node) {
    number[node] += first_node[static_cast<std::size_t>(owner[node])];
  }
  std::vector<Index> degrees, neighbors;
  for (Index node = 0; node < graph.own; ++node) {
    degrees.push_back(static_cast<Index>(graph.adjacency->of(node).size()));
    for (const Index other : graph.adjacency->of(node)) neighbors.push_back(number[other]);
  }
  GatheredRows rows;
  for (const Index degree : joined<Index>(ranks.gather(std::as_bytes(std::span(degrees))))) {
    rows.begin.push_back(rows.begin.back() + degree);
  }
  rows.neighbors = joined<Index>(ranks.gather(std::as_bytes(std::span(neighbors))));
  return rows;
}

/// The same rows under other numbers.
Adjacency renumbered(const GatheredRows& rows, std::span<const Index> number_of) {
  std::vector<Index> row_of(rows.count());
  for (Index row = 0; row < rows.count(); ++row) row_of[number_of[row]] = row;
  Adjacency adjacency;
  std::vector<Index> sorted;
  for (const Index row : row_of) {
    sorted.clear();
    for (const Index neighbor : rows.of(row)) sorted.push_back(number_of[neighbor]);
    std::ranges::sort(sorted);
    adjacency.neighbors.insert(adjacency.neighbors.end(), sorted.begin(), sorted.end());
    adjacency.offsets.push_back(static_cast<Index>(adjacency.neighbors.size()));
  }
  return adjacency;
}

std::vector<Index> own_nodes(const RankGraph& graph) {
  std::vector<Index> nodes(graph.own);
  std::iota(nodes.begin(), nodes.end(), Index{0});
  return nodes;
}

}  // namespace

GatheredLevels::GatheredLevels(Communicator& ranks, const RankGraph& graph, const Level& level,
                               Gathering gathering, const Progress& progress)
    : is_finest_(gathering.is_finest),
      number_of_(std::move(gathering.number_of)),
      hierarchy_(std::move(gathering.hierarchy)),
      packer_(graph.adjacency, own_nodes(graph)) {
  gather_graph(ranks, graph);
  gather_couplings(ranks, level);
  ranks.together([&] {
    if (ranks.rank() != 0) return;
    // Levels that are there have aggregates, and what this level's couplings gave.
    if (hierarchy_.levels.size() == 1) coarsen(hierarchy_, progress);
  });
}

void GatheredLevels::gather_graph(Communicator& ranks, const RankGraph& graph) {
  first_node_.assign(1, 0);
  for (const Index own : ranks.all(graph.own)) first_node_.push_back(first_node_.back() + own);
  const GatheredRows rows = gather_rows(ranks, graph, first_node_);
  ranks.together([&] {
    if (ranks.rank() != 0) return;
    if (number_of_.empty()) {
      number_of_.resize(rows.count());
      std::iota(number_of_.begin(), number_of_.end(), Index{0});
    }
    if (hierarchy_.levels.empty()) hierarchy_ = finest_level(renumbered(rows, number_of_));
    const SlicedLayout& layout = hierarchy_.levels[0].layout();
    std::vector<Index> slots;
    for (std::size_t r = 0; r + 1 < first_node_.size(); ++r) {
      RowPlaces& places = places_.emplace_back();
      for (Index row = first_node_[r]; row < first_node_[r + 1]; ++row) {
        slots.clear();
        for (const Index other : rows.of(row)) slots.push_back(layout.slot_of[number_of_[other]]);
        places.add(layout, layout.slot_of[number_of_[row]], slots);
      }
    }
  });
}

void GatheredLevels::gather_couplings(Communicator& ranks, const Level& level) {
  packer_.pack(level, packed_);
  const auto parts = ranks.gather(packed_);
  if (ranks.rank() != 0) return;
  load_rows(parts, places_, hierarchy_.levels[0].layout(), hierarchy_.levels[0].couplings);
}

void GatheredLevels::scatter(Communicator& ranks, const RankGraph& graph, Level& level) {
  std::vector<Outgoing> outgoing;
  own_z_.resize(graph.own);
  if (ranks.rank() == 0) {
    const Level& gathered = hierarchy_.levels[0];
    z_.resize(number_of_.size());
    for (std::size_t row = 0; row < z_.size(); ++row) {
      z_[row] = gathered.z[gathered.layout().slot_of[number_of_[row]]];
    }
    for (int r = 0; r < ranks.size(); ++r) {
      const Index first = first_node_[static_cast<std::size_t>(r)];
      const Index end = first_node_[static_cast<std::size_t>(r) + 1];
      outgoing.push_back({r, std::as_bytes(std::span(z_).subspan(first, end - first))});
    }
  }
  const Incoming incoming{0, std::as_writable_bytes(std::span(own_z_))};
  ranks.transfer(outgoing, {&incoming, 1});
  to_slots(level.layout(), own_z_, level.z);
}

void GatheredLevels::renew(Communicator& ranks, const Level& level) {
  gather_couplings(ranks, level);
  if (ranks.rank() == 0) brindle::renew(hierarchy_);
}

void GatheredLevels::descend(Communicator& ranks, const RankGraph& graph, int sweeps,
                             Level& level) {
  if (ranks.rank() == 0) brindle::descend(hierarchy_, sweeps);
  scatter(ranks, graph, level);
}

void GatheredLevels::correct(Communicator& ranks, const RankGraph& graph, int sweeps,
                             Level& level) {
  if (!is_finest_) gather_couplings(ranks, level);
  if (ranks.rank() == 0) brindle::correct(hierarchy_, sweeps, is_finest_);
  scatter(ranks, graph, level);
}

}  // namespace brindle
