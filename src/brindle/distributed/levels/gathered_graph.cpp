#include "brindle/distributed/levels/gathered_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace brindle {

Adjacency GatheredGraph::adjacency() const {
  std::vector<Index> node_of(node_count());
  for (Index node = 0; node < node_count(); ++node) node_of[number_of[node]] = node;
  Adjacency result;
  std::vector<Index> row;
  for (const Index node : node_of) {
    row.clear();
    for (const Index neighbor : of(node)) row.push_back(number_of[neighbor]);
    std::ranges::sort(row);
    result.neighbors.insert(result.neighbors.end(), row.begin(), row.end());
    result.offsets.push_back(static_cast<Index>(result.neighbors.size()));
  }
  return result;
}

GatheredGraph gather_graph(Communicator& ranks, const RankGraph& graph,
                           std::vector<Index> number_of) {
  GatheredGraph gathered;
  gathered.first_node.assign(1, 0);
  for (const Index own : ranks.all(graph.own)) {
    gathered.first_node.push_back(gathered.first_node.back() + own);
  }
  const std::vector<int> owner = owners(ranks, graph);
  std::vector<Index> number = numbers_on_owners(ranks, graph);
  for (Index node = 0; node < number.size(); ++node) {
    number[node] += gathered.first_node[static_cast<std::size_t>(owner[node])];
  }
  std::vector<Index> degrees, neighbors;
  for (Index node = 0; node < graph.own; ++node) {
    degrees.push_back(static_cast<Index>(graph.adjacency->of(node).size()));
    for (const Index other : graph.adjacency->of(node)) neighbors.push_back(number[other]);
  }
  for (const Index degree : joined<Index>(ranks.gather(std::as_bytes(std::span(degrees))))) {
    gathered.begin.push_back(gathered.begin.back() + degree);
  }
  gathered.neighbors = joined<Index>(ranks.gather(std::as_bytes(std::span(neighbors))));
  gathered.number_of = std::move(number_of);
  if (gathered.number_of.empty()) {
    gathered.number_of.resize(gathered.node_count());
    std::iota(gathered.number_of.begin(), gathered.number_of.end(), Index{0});
  }
  return gathered;
}

std::vector<Index> numbers_by_id(Communicator& ranks, std::span<const std::uint64_t> own_ids) {
  const auto ids = joined<std::uint64_t>(ranks.gather(std::as_bytes(own_ids)));
  std::vector<Index> order(ids.size()), number(ids.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, [&](Index node) { return ids[node]; });
  for (Index n = 0; n < order.size(); ++n) number[order[n]] = n;
  return number;
}

}  // namespace brindle
