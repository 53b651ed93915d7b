#include "brindle/distributed/halo.h"

namespace brindle {
namespace {

/// Slots of some nodes, a row per colour, in the order of the nodes.
template <class NodeAt>
CompressedRows<Index> slots_by_color(std::size_t count, const NodeAt& node_at,
                                     const SlicedLayout& layout, const Coloring& coloring,
                                     Index color_count) {
  return compressed_rows<Index>(color_count, [&](const auto& add) {
    for (std::size_t n = 0; n < count; ++n) {
      const Index node = node_at(n);
      add(coloring.color[node], layout.slot_of[node]);
    }
  });
}

}  // namespace

SlotHalo::SlotHalo(const NodeHalo& halo, const SlicedLayout& layout, const Coloring& coloring,
                   Index color_count)
    : color_count_(color_count) {
  for (const HaloNeighbor& other : halo) {
    Neighbor neighbor;
    neighbor.rank = other.rank;
    neighbor.sent = slots_by_color(
        other.sent.size(), [&](std::size_t n) { return other.sent[n]; }, layout, coloring,
        color_count);
    neighbor.received = slots_by_color(
        other.count, [&](std::size_t n) { return other.first + static_cast<Index>(n); }, layout,
        coloring, color_count);
    neighbor.out.resize(neighbor.sent.entries.size());
    neighbor.in.resize(neighbor.received.entries.size());
    neighbors_.push_back(std::move(neighbor));
  }
  outgoing_.reserve(neighbors_.size());
  incoming_.reserve(neighbors_.size());
}

void SlotHalo::start(Communicator& ranks, std::span<const Complex> by_slot, Index first,
                     Index end) {
  outgoing_.clear();
  incoming_.clear();
  for (Neighbor& neighbor : neighbors_) {
    const Index sent = neighbor.sent.offsets[first], sent_end = neighbor.sent.offsets[end];
    for (Index n = sent; n < sent_end; ++n) neighbor.out[n] = by_slot[neighbor.sent.entries[n]];
    const Index received = neighbor.received.offsets[first];
    outgoing_.push_back(
        {neighbor.rank, std::as_bytes(std::span(neighbor.out).subspan(sent, sent_end - sent))});
    incoming_.push_back(
        {neighbor.rank,
         std::as_writable_bytes(
             std::span(neighbor.in).subspan(received, neighbor.received.offsets[end] - received))});
  }
  ranks.start(outgoing_, incoming_);
}

void SlotHalo::finish(Communicator& ranks, std::span<Complex> by_slot, Index first, Index end) {
  ranks.finish();
  for (const Neighbor& neighbor : neighbors_) {
    const CompressedRows<Index>& received = neighbor.received;
    for (Index n = received.offsets[first]; n < received.offsets[end]; ++n) {
      by_slot[received.entries[n]] = neighbor.in[n];
    }
  }
}

void SlotHalo::exchange(Communicator& ranks, std::span<Complex> by_slot) {
  start(ranks, by_slot, 0, color_count_);
  finish(ranks, by_slot, 0, color_count_);
}

std::size_t SlotHalo::ghost_count() const {
  std::size_t count = 0;
  for (const Neighbor& neighbor : neighbors_) count += neighbor.received.entries.size();
  return count;
}

}  // namespace brindle
