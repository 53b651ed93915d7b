#include "brindle/distributed/halo.h"

#include <algorithm>

namespace brindle {
namespace {

/// Slots of some nodes, colour by colour, in a colour in the order of the nodes; `begin` receives
/// where each colour begins.
template <class NodeAt>
std::vector<Index> slots_by_color(std::size_t count, const NodeAt& node_at,
                                  const SlicedLayout& layout, const Coloring& coloring,
                                  Index color_count, std::vector<Index>& begin) {
  begin.assign(color_count + 1, 0);
  for (std::size_t n = 0; n < count; ++n) ++begin[coloring.color[node_at(n)] + 1];
  for (Index c = 0; c < color_count; ++c) begin[c + 1] += begin[c];
  std::vector<Index> next(begin.begin(), begin.end() - 1);
  std::vector<Index> slots(count);
  for (std::size_t n = 0; n < count; ++n) {
    const Index node = node_at(n);
    slots[next[coloring.color[node]]++] = layout.slot_of[node];
  }
  return slots;
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
        color_count, neighbor.sent_begin);
    neighbor.received = slots_by_color(
        other.count, [&](std::size_t n) { return other.first + static_cast<Index>(n); }, layout,
        coloring, color_count, neighbor.received_begin);
    neighbor.out.resize(neighbor.sent.size());
    neighbor.in.resize(neighbor.received.size());
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
    const Index sent = neighbor.sent_begin[first], sent_end = neighbor.sent_begin[end];
    for (Index n = sent; n < sent_end; ++n) neighbor.out[n] = by_slot[neighbor.sent[n]];
    const Index received = neighbor.received_begin[first];
    outgoing_.push_back(
        {neighbor.rank, std::as_bytes(std::span(neighbor.out).subspan(sent, sent_end - sent))});
    incoming_.push_back(
        {neighbor.rank,
         std::as_writable_bytes(
             std::span(neighbor.in).subspan(received, neighbor.received_begin[end] - received))});
  }
  ranks.start(outgoing_, incoming_);
}

void SlotHalo::finish(Communicator& ranks, std::span<Complex> by_slot, Index first, Index end) {
  ranks.finish();
  for (const Neighbor& neighbor : neighbors_) {
    for (Index n = neighbor.received_begin[first]; n < neighbor.received_begin[end]; ++n) {
      by_slot[neighbor.received[n]] = neighbor.in[n];
    }
  }
}

void SlotHalo::exchange(Communicator& ranks, std::span<Complex> by_slot) {
  start(ranks, by_slot, 0, color_count_);
  finish(ranks, by_slot, 0, color_count_);
}

std::size_t SlotHalo::ghost_count() const {
  std::size_t count = 0;
  for (const Neighbor& neighbor : neighbors_) count += neighbor.received.size();
  return count;
}

}  // namespace brindle
