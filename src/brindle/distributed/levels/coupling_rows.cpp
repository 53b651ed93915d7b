#include "brindle/distributed/levels/coupling_rows.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {
namespace {

/// A reflecting coupling of a packed edge.
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

/// Loads the rows of one rank; reflecting couplings are only collected.
void load_part(std::span<const std::byte> bytes, const RowPlaces& places,
               const SlicedLayout& layout, SlicedCouplings& couplings,
               std::vector<ReflectingCoupling>& reflecting) {
  std::vector<Complex> direct(places.entry.size()), anchors;
  take(bytes, std::span(direct));
  for (std::size_t e = 0; e < direct.size(); ++e) couplings.set_direct(places.entry[e], direct[e]);
  std::uint8_t anchored = 0;
  take(bytes, std::span(&anchored, 1));
  anchors.resize(anchored ? places.slot.size() : 0);
  take(bytes, std::span(anchors));
  if (anchored && couplings.anchor.empty()) couplings.anchor.resize(layout.slot_count());
  for (std::size_t r = 0; r < anchors.size(); ++r) couplings.anchor[places.slot[r]] = anchors[r];
  std::vector<EdgeReflection> reflections(bytes.size() / sizeof(EdgeReflection));
  take(bytes, std::span(reflections));
  for (const auto& [edge, b] : reflections) reflecting.push_back({places.entry[edge], b});
}

/// Direct couplings and anchors; reflecting ones are only collected.
void copy_local(const LocalRows& local, const SlicedLayout& layout, SlicedCouplings& couplings,
                std::vector<ReflectingCoupling>& reflecting) {
  const auto& level = local.level;
  const auto& rows = local.rows;
  const auto& places = local.places;
  const std::vector<Complex>& anchor = level.couplings.anchor;
  if (!anchor.empty() && couplings.anchor.empty()) couplings.anchor.resize(layout.slot_count());
  const auto copy_row = [&](std::size_t row) {
    const Index slot = level.layout().slot_of[rows.nodes()[row]];
    std::size_t from = level.layout().first_entry(slot);
    for (Index e = places.edge_begin[row]; e < places.edge_begin[row + 1]; ++e, from += kLanes) {
      couplings.set_direct(places.entry[e], level.couplings.direct_at(from));
    }
    if (!anchor.empty()) couplings.anchor[places.slot[row]] = anchor[slot];
  };
  parallel_for(rows.nodes().size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) copy_row(row);
  });
  rows.for_each_reflection(level, [&](Index edge, Complex b) {
    reflecting.push_back({places.entry[edge], b});
  });
}

}  // namespace

RowPacker::RowPacker(std::shared_ptr<const Adjacency> adjacency, std::vector<Index> nodes)
    : adjacency_(std::move(adjacency)),
      nodes_(std::move(nodes)),
      first_edge_(adjacency_->node_count(), kNone) {
  Index edge = 0;
  for (const Index node : nodes_) {
    first_edge_[node] = edge;
    edge += static_cast<Index>(adjacency_->of(node).size());
  }
}

void RowPacker::pack(const Level& level, std::vector<std::byte>& bytes) const {
  const SlicedLayout& layout = level.layout();
  const SlicedCouplings& couplings = level.couplings;
  std::vector<Complex> direct, anchors;
  for (const Index node : nodes_) {
    std::size_t entry = layout.first_entry(layout.slot_of[node]);
    for (std::size_t k = 0; k < adjacency_->of(node).size(); ++k, entry += kLanes) {
      direct.push_back(couplings.direct_at(entry));
    }
    if (!couplings.anchor.empty()) anchors.push_back(couplings.anchor[layout.slot_of[node]]);
  }
  std::vector<EdgeReflection> reflections;
  for_each_reflection(level, [&](Index edge, Complex b) { reflections.push_back({edge, b}); });
  const std::uint8_t anchored = couplings.anchor.empty() ? 0 : 1;
  bytes.clear();
  append(bytes, std::span<const Complex>(direct));
  append(bytes, std::span(&anchored, 1));
  append(bytes, std::span<const Complex>(anchors));
  append(bytes, std::span<const EdgeReflection>(reflections));
}

void RowPlaces::add(const SlicedLayout& layout, Index row_slot,
                    std::span<const Index> neighbor_slots) {
  const std::size_t first = layout.first_entry(row_slot);
  const std::size_t end = first + std::size_t{layout.width(row_slot)} * kLanes;
  for (const Index neighbor : neighbor_slots) {
    std::size_t at = first;
    while (at < end && layout.neighbor[at] != neighbor) at += kLanes;
    if (at >= end) throw Error("distributed levels: two ranks do not have the same edges");
    entry.push_back(static_cast<Index>(at));
  }
  slot.push_back(row_slot);
  edge_begin.push_back(static_cast<Index>(entry.size()));
}

void load_rows(std::span<const std::vector<std::byte>> parts, std::span<const RowPlaces> places,
               const SlicedLayout& layout, SlicedCouplings& couplings, const LocalRows* local) {
  std::vector<ReflectingCoupling> reflecting;
  couplings.anchor.clear();
  for (std::size_t r = 0; r < parts.size(); ++r) {
    if (parts[r].empty()) continue;
    load_part(parts[r], places[r], layout, couplings, reflecting);
  }
  if (local != nullptr) copy_local(*local, layout, couplings, reflecting);
  std::ranges::sort(reflecting, {}, &ReflectingCoupling::entry);
  std::ranges::fill(couplings.reflecting_count, Index{0});
  Index slice = 0;
  for (const ReflectingCoupling& coupling : reflecting) {
    while (coupling.entry >= std::size_t{layout.column_begin[slice + 1]} * kLanes) ++slice;
    couplings.append_reflecting(layout, slice, coupling);
  }
}

}  // namespace brindle
