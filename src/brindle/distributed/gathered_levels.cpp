#include "brindle/distributed/gathered_levels.h"

#include <algorithm>
#include <utility>

#include "brindle/phases/multilevel.h"

namespace brindle {
namespace {

/// A reflecting coupling of a rank's directed edge.
struct EdgeReflection {
  Index edge;
  Complex b;
};

template <class T>
void append(std::vector<std::byte>& bytes, std::span<const T> values) {
  const auto more = std::as_bytes(values);
  bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Takes `values.size()` values from the front.
template <class T>
void take(std::span<const std::byte>& bytes, std::span<T> values) {
  std::ranges::copy(bytes.first(values.size_bytes()), std::as_writable_bytes(values).begin());
  bytes = bytes.subspan(values.size_bytes());
}

/// Direct couplings edge by edge, whether there are anchors, these node by node, then reflecting
/// couplings.
void pack(const RankGraph& graph, const Level& level, std::vector<std::byte>& bytes) {
  const SlicedLayout& layout = level.layout();
  const SlicedCouplings& couplings = level.couplings;
  const std::vector<Index>& offsets = graph.adjacency->offsets;
  std::vector<Complex> direct, anchors;
  for (Index node = 0; node < graph.own; ++node) {
    std::size_t entry = layout.first_entry(layout.slot_of[node]);
    for (Index edge = offsets[node]; edge < offsets[node + 1]; ++edge, entry += kLanes) {
      direct.push_back(couplings.direct_at(entry));
    }
    if (!couplings.anchor.empty()) anchors.push_back(couplings.anchor[layout.slot_of[node]]);
  }
  std::vector<EdgeReflection> reflections;
  for (Index slice = 0; slice < layout.slice_count(); ++slice) {
    for (const auto& [entry, b] : couplings.reflecting_of(layout, slice)) {
      const Index node = layout.node_at[slice * kLanes + entry % kLanes];
      const Index column = entry / kLanes - layout.column_begin[slice];
      reflections.push_back({offsets[node] + column, b});
    }
  }
  const std::uint8_t anchored = couplings.anchor.empty() ? 0 : 1;
  bytes.clear();
  append(bytes, std::span<const Complex>(direct));
  append(bytes, std::span(&anchored, 1));
  append(bytes, std::span<const Complex>(anchors));
  append(bytes, std::span<const EdgeReflection>(reflections));
}

/// The rows of a gathered graph.
struct GatheredRows {
  Adjacency adjacency;
  std::vector<Index> place;  ///< of the ranks' directed edges in their rows
};

/// `degrees` by node and `neighbors` by directed edge, in the order in which the ranks have them.
GatheredRows sorted_rows(std::span<const Index> degrees, std::span<const Index> neighbors) {
  GatheredRows rows;
  rows.place.resize(neighbors.size());
  std::vector<std::pair<Index, Index>> row;  // neighbour, directed edge
  Index edge = 0;
  for (const Index degree : degrees) {
    row.clear();
    for (Index k = 0; k < degree; ++k, ++edge) row.emplace_back(neighbors[edge], edge);
    std::ranges::sort(row);
    for (Index k = 0; k < degree; ++k) {
      rows.adjacency.neighbors.push_back(row[k].first);
      rows.place[row[k].second] = k;
    }
    rows.adjacency.offsets.push_back(static_cast<Index>(rows.adjacency.neighbors.size()));
  }
  return rows;
}

}  // namespace

GatheredLevels::GatheredLevels(Communicator& ranks, const RankGraph& graph, const Level& level,
                               bool is_finest, const Progress& progress)
    : is_finest_(is_finest) {
  gather_graph(ranks, graph);
  gather_couplings(ranks, graph, level);
  ranks.together([&] {
    if (ranks.rank() == 0) coarsen(hierarchy_, progress);
  });
}

/// Nodes are numbered rank by rank.
void GatheredLevels::gather_graph(Communicator& ranks, const RankGraph& graph) {
  first_node_.assign(1, 0);
  first_edge_.assign(1, 0);
  const Index own_edges = graph.adjacency->offsets[graph.own];
  for (const Index own : ranks.all(graph.own)) first_node_.push_back(first_node_.back() + own);
  for (const Index edges : ranks.all(own_edges)) {
    first_edge_.push_back(first_edge_.back() + edges);
  }
  const std::vector<int> owner = owners(ranks, graph);
  std::vector<Index> number = numbers_on_owners(ranks, graph);
  for (Index node = 0; node < number.size(); ++node) {
    number[node] += first_node_[static_cast<std::size_t>(owner[node])];
  }
  std::vector<Index> degrees, neighbors;
  for (Index node = 0; node < graph.own; ++node) {
    degrees.push_back(static_cast<Index>(graph.adjacency->of(node).size()));
    for (const Index other : graph.adjacency->of(node)) neighbors.push_back(number[other]);
  }
  const auto all_degrees = joined<Index>(ranks.gather(std::as_bytes(std::span(degrees))));
  const auto all_neighbors = joined<Index>(ranks.gather(std::as_bytes(std::span(neighbors))));
  ranks.together([&] {
    if (ranks.rank() != 0) return;
    const GatheredRows rows = sorted_rows(all_degrees, all_neighbors);
    hierarchy_ = finest_level(rows.adjacency);
    const SlicedLayout& layout = hierarchy_.levels[0].layout();
    std::size_t edge = 0;
    for (Index node = 0; node < all_degrees.size(); ++node) {
      const std::size_t entry = layout.first_entry(layout.slot_of[node]);
      for (Index k = 0; k < all_degrees[node]; ++k, ++edge) {
        entry_of_edge_.push_back(static_cast<Index>(entry + rows.place[edge] * kLanes));
      }
    }
  });
}

void GatheredLevels::gather_couplings(Communicator& ranks, const RankGraph& graph,
                                      const Level& level) {
  pack(graph, level, packed_);
  const auto parts = ranks.gather(packed_);
  if (ranks.rank() == 0) load(parts);
}

void GatheredLevels::load(std::span<const std::vector<std::byte>> parts) {
  Level& finest = hierarchy_.levels[0];
  const SlicedLayout& layout = finest.layout();
  SlicedCouplings& couplings = finest.couplings;
  std::vector<ReflectingCoupling> reflecting;
  std::vector<Complex> direct, anchors;
  couplings.anchor.clear();
  for (std::size_t r = 0; r < parts.size(); ++r) {
    std::span<const std::byte> bytes = parts[r];
    const std::size_t first = first_edge_[r];
    direct.resize(first_edge_[r + 1] - first);
    take(bytes, std::span(direct));
    for (std::size_t e = 0; e < direct.size(); ++e) {
      couplings.set_direct(entry_of_edge_[first + e], direct[e]);
    }
    std::uint8_t anchored = 0;
    take(bytes, std::span(&anchored, 1));
    anchors.resize(anchored ? first_node_[r + 1] - first_node_[r] : 0);
    take(bytes, std::span(anchors));
    if (anchored && couplings.anchor.empty()) couplings.anchor.resize(layout.slot_count());
    for (std::size_t n = 0; n < anchors.size(); ++n) {
      couplings.anchor[layout.slot_of[first_node_[r] + n]] = anchors[n];
    }
    std::vector<EdgeReflection> reflections(bytes.size() / sizeof(EdgeReflection));
    take(bytes, std::span(reflections));
    for (const auto& [edge, b] : reflections) {
      reflecting.push_back({entry_of_edge_[first + edge], b});
    }
  }
  std::ranges::sort(reflecting, {}, &ReflectingCoupling::entry);
  std::ranges::fill(couplings.reflecting_count, Index{0});
  Index slice = 0;
  for (const ReflectingCoupling& coupling : reflecting) {
    while (coupling.entry >= std::size_t{layout.column_begin[slice + 1]} * kLanes) ++slice;
    couplings.append_reflecting(layout, slice, coupling);
  }
}

void GatheredLevels::scatter(Communicator& ranks, const RankGraph& graph, Level& level) {
  std::vector<Outgoing> outgoing;
  own_z_.resize(graph.own);
  if (ranks.rank() == 0) {
    to_nodes(hierarchy_.levels[0].layout(), hierarchy_.levels[0].z, z_);
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

void GatheredLevels::renew(Communicator& ranks, const RankGraph& graph, const Level& level) {
  gather_couplings(ranks, graph, level);
  if (ranks.rank() == 0) brindle::renew(hierarchy_);
}

void GatheredLevels::descend(Communicator& ranks, const RankGraph& graph, int sweeps,
                             Level& level) {
  if (ranks.rank() == 0) brindle::descend(hierarchy_, sweeps);
  scatter(ranks, graph, level);
}

void GatheredLevels::correct(Communicator& ranks, const RankGraph& graph, int sweeps,
                             Level& level) {
  if (!is_finest_) gather_couplings(ranks, graph, level);
  if (ranks.rank() == 0) brindle::correct(hierarchy_, sweeps, is_finest_);
  scatter(ranks, graph, level);
}

}  // namespace brindle
