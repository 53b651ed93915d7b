/// Values of ghosts: neighbours of own nodes that other ranks own.
#pragma once

#include <span>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/communicator.h"
#include "brindle/phases/coloring.h"
#include "brindle/phases/sliced_graph.h"

namespace brindle {

/// The nodes that two ranks exchange.
struct HaloNeighbor {
  int rank;
  std::vector<Index> sent;  ///< own nodes, in the order of the other rank's ghosts
  Index first = 0;          ///< the other rank's nodes are the ghosts first .. first + count - 1
  Index count = 0;
};

/// Sorted by rank.
using NodeHalo = std::vector<HaloNeighbor>;

/// Sets ghosts to their owners' values.
template <class T>
void exchange(Communicator& ranks, const NodeHalo& halo, std::span<T> by_node) {
  std::vector<std::vector<T>> packed;
  std::vector<Outgoing> outgoing;
  std::vector<Incoming> incoming;
  packed.reserve(halo.size());
  for (const HaloNeighbor& neighbor : halo) {
    std::vector<T>& values = packed.emplace_back();
    values.reserve(neighbor.sent.size());
    for (const Index node : neighbor.sent) values.push_back(by_node[node]);
    outgoing.push_back({neighbor.rank, std::as_bytes(std::span(values))});
    incoming.push_back(
        {neighbor.rank, std::as_writable_bytes(by_node.subspan(neighbor.first, neighbor.count))});
  }
  ranks.transfer(outgoing, incoming);
}

/// The same for slots of a level, all at once or one colour at a time, with 8 bytes per ghost in
/// total.
class SlotHalo {
 public:
  SlotHalo() = default;

  /// `coloring` gives a node and its ghosts the same colour.
  SlotHalo(const NodeHalo& halo, const SlicedLayout& layout, const Coloring& coloring,
           Index color_count);

  /// Sends own values of the colours first .. end - 1; `finish` with the same colours receives the
  /// ghosts'. In between, `by_slot` may be read, and changed in other colours.
  void start(Communicator& ranks, std::span<const Complex> by_slot, Index first, Index end);
  void finish(Communicator& ranks, std::span<Complex> by_slot, Index first, Index end);

  /// Exchanges all colours at once.
  void exchange(Communicator& ranks, std::span<Complex> by_slot);

  /// The number of ghosts.
  std::size_t ghost_count() const;

 private:
  struct Neighbor {
    int rank;
    CompressedRows<Index> sent, received;  ///< slots, a row per colour
    std::vector<Complex> out, in;          ///< parallel to their entries
  };
  Index color_count_ = 0;
  std::vector<Neighbor> neighbors_;
  std::vector<Outgoing> outgoing_;
  std::vector<Incoming> incoming_;
};

}  // namespace brindle
