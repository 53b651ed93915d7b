#include "brindle/distributed/levels/gathered_levels.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "brindle/error.h"

namespace brindle {
namespace {

/// A reflecting coupling of an edge.
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

/// The entry of a neighbour in a row of the layout.
Index entry_of(const SlicedLayout& layout, Index row_slot, Index neighbor_slot) {
  std::size_t entry = layout.first_entry(row_slot);
  const std::size_t end = entry + std::size_t{layout.width(row_slot)} * kLanes;
  while (entry < end && layout.neighbor[entry] != neighbor_slot) entry += kLanes;
  if (entry >= end) throw Error("distributed levels: two ranks do not have the same edges");
  return static_cast<Index>(entry);
}

}  // namespace

GatheredLevels::GatheredLevels(Communicator& ranks, const RankGraph& graph, const Level& level,
                               const Progress& progress)
    : adjacency_(graph.adjacency),
      nodes_(ranks, graph.own),
      edges_(ranks, graph.adjacency->neighbors.size()),
      own_z_(graph.own) {
  lay_out(ranks, graph);
  gather_couplings(ranks, level);
  ranks.on_first(progress, [&](const Progress& heard) { coarsen(hierarchy_, heard); });
}

void GatheredLevels::lay_out(Communicator& ranks, const RankGraph& graph) {
  std::vector<Index> number(graph.node_count());
  std::iota(number.begin(), number.end(), nodes_.first(ranks.rank()));
  exchange(ranks, graph.halo, std::span(number));
  std::vector<Index> degrees, neighbors, all_degrees, all_neighbors;
  for (Index node = 0; node < graph.own; ++node) {
    degrees.push_back(static_cast<Index>(adjacency_->of(node).size()));
    for (const Index other : adjacency_->of(node)) neighbors.push_back(number[other]);
  }
  nodes_.gather(std::span<const Index>(degrees), all_degrees);
  edges_.gather(std::span<const Index>(neighbors), all_neighbors);
  ranks.throw_on_all([&] {
    if (ranks.rank() == 0) add_entries(all_degrees, all_neighbors);
  });
}

void GatheredLevels::add_entries(std::span<const Index> degrees, std::span<const Index> neighbors) {
  Adjacency sorted;
  sorted.neighbors.assign(neighbors.begin(), neighbors.end());
  for (const Index degree : degrees) {
    const auto row = sorted.neighbors.begin() + sorted.offsets.back();
    std::sort(row, row + degree);
    sorted.offsets.push_back(sorted.offsets.back() + degree);
  }
  hierarchy_ = finest_level(sorted);
  const SlicedLayout& layout = hierarchy_.levels[0].layout();
  for (Index node = 0; node < degrees.size(); ++node) {
    for (Index e = sorted.offsets[node]; e < sorted.offsets[node + 1]; ++e) {
      entry_of_.push_back(entry_of(layout, layout.slot_of[node], layout.slot_of[neighbors[e]]));
    }
  }
}

/// Direct couplings per edge, a flag for anchors, anchors per node, then reflecting couplings.
void GatheredLevels::pack(const Level& level) {
  const SlicedLayout& layout = level.layout();
  const SlicedCouplings& couplings = level.couplings;
  std::vector<Complex> direct, anchors;
  const auto own = static_cast<Index>(own_z_.size());
  for (Index node = 0; node < own; ++node) {
    std::size_t entry = layout.first_entry(layout.slot_of[node]);
    for (std::size_t k = 0; k < adjacency_->of(node).size(); ++k, entry += kLanes) {
      direct.push_back(couplings.direct_at(entry));
    }
    if (!couplings.anchor.empty()) anchors.push_back(couplings.anchor[layout.slot_of[node]]);
  }
  std::vector<EdgeReflection> reflections;
  for (Index slice = 0; slice < layout.slice_count(); ++slice) {
    for (const auto& [entry, b] : couplings.reflecting_of(layout, slice)) {
      const Index node = layout.node_at[slice * kLanes + entry % kLanes];
      if (node >= own) continue;
      reflections.push_back(
          {adjacency_->offsets[node] + entry / kLanes - layout.column_begin[slice], b});
    }
  }
  const std::uint8_t anchored = couplings.anchor.empty() ? 0 : 1;
  packed_.clear();
  append(packed_, std::span<const Complex>(direct));
  append(packed_, std::span(&anchored, 1));
  append(packed_, std::span<const Complex>(anchors));
  append(packed_, std::span<const EdgeReflection>(reflections));
}

/// Unpacks a rank's data; reflecting couplings are only collected.
void GatheredLevels::load(std::span<const std::byte> packed, int rank,
                          std::vector<ReflectingCoupling>& reflecting) {
  const SlicedLayout& layout = hierarchy_.levels[0].layout();
  SlicedCouplings& couplings = hierarchy_.levels[0].couplings;
  const Index first_edge = edges_.first(rank), first_node = nodes_.first(rank);
  std::vector<Complex> direct(edges_.first(rank + 1) - first_edge), anchors;
  take(packed, std::span(direct));
  for (std::size_t e = 0; e < direct.size(); ++e) {
    couplings.set_direct(entry_of_[first_edge + e], direct[e]);
  }
  std::uint8_t anchored = 0;
  take(packed, std::span(&anchored, 1));
  anchors.resize(anchored ? nodes_.first(rank + 1) - first_node : 0);
  take(packed, std::span(anchors));
  if (anchored && couplings.anchor.empty()) couplings.anchor.resize(layout.slot_count());
  for (std::size_t n = 0; n < anchors.size(); ++n) {
    couplings.anchor[layout.slot_of[first_node + n]] = anchors[n];
  }
  std::vector<EdgeReflection> reflections(packed.size() / sizeof(EdgeReflection));
  take(packed, std::span(reflections));
  for (const auto& [edge, b] : reflections) {
    reflecting.push_back({entry_of_[first_edge + edge], b});
  }
}

void GatheredLevels::gather_couplings(Communicator& ranks, const Level& level) {
  pack(level);
  const auto parts = ranks.gather(packed_);
  if (ranks.rank() != 0) return;
  const SlicedLayout& layout = hierarchy_.levels[0].layout();
  SlicedCouplings& couplings = hierarchy_.levels[0].couplings;
  couplings.anchor.clear();
  std::vector<ReflectingCoupling> reflecting;
  for (int r = 0; r < ranks.size(); ++r) load(parts[static_cast<std::size_t>(r)], r, reflecting);
  std::ranges::sort(reflecting, {}, &ReflectingCoupling::entry);
  std::ranges::fill(couplings.reflecting_count, Index{0});
  Index slice = 0;
  for (const ReflectingCoupling& coupling : reflecting) {
    while (coupling.entry >= std::size_t{layout.column_begin[slice + 1]} * kLanes) ++slice;
    couplings.append_reflecting(layout, slice, coupling);
  }
}

void GatheredLevels::scatter(Level& level) {
  if (!hierarchy_.levels.empty()) {
    const Level& first = hierarchy_.levels[0];
    z_.resize(nodes_.count());
    for (Index node = 0; node < z_.size(); ++node) z_[node] = first.z[first.layout().slot_of[node]];
  }
  nodes_.scatter(std::span<const Complex>(z_), std::span(own_z_));
  to_slots(level.layout(), own_z_, level.z);
}

void GatheredLevels::renew(Communicator& ranks, const Level& level) {
  gather_couplings(ranks, level);
  if (ranks.rank() == 0) brindle::renew(hierarchy_);
}

void GatheredLevels::descend(Communicator& ranks, SweepPlan plan, Level& level) {
  if (ranks.rank() == 0) brindle::descend(hierarchy_, plan);
  scatter(level);
}

void GatheredLevels::correct(Communicator& ranks, SweepPlan plan, Level& level) {
  gather_couplings(ranks, level);
  if (ranks.rank() == 0) brindle::correct(hierarchy_, plan, false);
  scatter(level);
}

}  // namespace brindle
