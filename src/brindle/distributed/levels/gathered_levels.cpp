#include "brindle/distributed/levels/gathered_levels.h"

#include <numeric>
#include <utility>

#include "brindle/phases/multilevel.h"

namespace brindle {
namespace {

std::vector<Index> own_nodes(const RankGraph& graph) {
  std::vector<Index> nodes(graph.own);
  std::iota(nodes.begin(), nodes.end(), Index{0});
  return nodes;
}

}  // namespace

GatheredLevels::GatheredLevels(Communicator& ranks, const RankGraph& graph, const Level& level,
                               Gathering gathering, const Progress& progress)
    : is_finest_(gathering.is_finest),
      graph_(gather_graph(ranks, graph, std::move(gathering.number_of))),
      hierarchy_(std::move(gathering.hierarchy)),
      packer_(graph.adjacency, own_nodes(graph)) {
  ranks.together([&] {
    if (ranks.rank() == 0) lay_out();
  });
  gather_couplings(ranks, level);
  ranks.together([&] {
    if (ranks.rank() != 0) return;
    // Levels that are there have aggregates, and what this level's couplings gave.
    if (hierarchy_.levels.size() == 1) coarsen(hierarchy_, progress);
  });
}

void GatheredLevels::lay_out() {
  if (hierarchy_.levels.empty()) hierarchy_ = finest_level(graph_.adjacency());
  const SlicedLayout& layout = hierarchy_.levels[0].layout();
  std::vector<Index> slots;
  for (std::size_t r = 0; r + 1 < graph_.first_node.size(); ++r) {
    RowPlaces& places = places_.emplace_back();
    for (Index node = graph_.first_node[r]; node < graph_.first_node[r + 1]; ++node) {
      slots.clear();
      for (const Index other : graph_.of(node)) slots.push_back(slot_of(other));
      places.add(layout, slot_of(node), slots);
    }
  }
  // The rows are in the places.
  graph_.neighbors = {};
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
    z_.resize(graph_.node_count());
    for (Index node = 0; node < z_.size(); ++node) z_[node] = hierarchy_.levels[0].z[slot_of(node)];
    for (int r = 0; r < ranks.size(); ++r) {
      const Index first = graph_.first_node[static_cast<std::size_t>(r)];
      const Index end = graph_.first_node[static_cast<std::size_t>(r) + 1];
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

void GatheredLevels::descend(Communicator& ranks, const RankGraph& graph, Level& level,
                             const std::function<void(Hierarchy&)>& solve) {
  if (ranks.rank() == 0) solve(hierarchy_);
  scatter(ranks, graph, level);
}

void GatheredLevels::take_phases(Communicator& ranks, const RankGraph& graph, const Level& level) {
  own_z_.clear();
  for (Index node = 0; node < graph.own; ++node) {
    own_z_.push_back(level.z[level.layout().slot_of[node]]);
  }
  const auto all = joined<Complex>(ranks.gather(std::as_bytes(std::span(own_z_))));
  for (Index node = 0; node < all.size(); ++node) hierarchy_.levels[0].z[slot_of(node)] = all[node];
}

void GatheredLevels::correct(Communicator& ranks, const RankGraph& graph, SweepPlan plan,
                             Level& level) {
  if (!is_finest_) gather_couplings(ranks, level);
  if (ranks.rank() == 0) brindle::correct(hierarchy_, plan, is_finest_);
  scatter(ranks, graph, level);
}

}  // namespace brindle
