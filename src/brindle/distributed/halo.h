/// Values of ghosts: nodes beside a rank's own that other ranks own.
#pragma once

#include <span>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/communicator.h"
#include "brindle/phases/coloring.h"
#include "brindle/phases/sliced_graph.h"

namespace brindle {

/// What one other rank needs of this one's nodes, and what this one needs of its.
struct HaloNeighbor {
  int rank;
  std::vector<Index> sent;  ///< own nodes, in the order in which the other rank has them as ghosts
  Index first = 0;          ///< its nodes are ghosts first .. first + count - 1 here
  Index count = 0;
};

/// Neighbours in the order of ranks.
using NodeHalo = std::vector<HaloNeighbor>;

/// Sets the ghosts' values to what their owners have.
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

/// The same by slots of a level, all at once or a colour at a time: 8 bytes a ghost either way.
class SlotHalo {
 public:
  SlotHalo() = default;

  /// `coloring` has the same colours for a node and its ghosts on other ranks.
  SlotHalo(const NodeHalo& halo, const SlicedLayout& layout, const Coloring& coloring,
           Index color_count);

  /// Sends own values of the colours first .. end - 1; ghosts have theirs after `finish` with the
  /// same colours. `by_slot` may be read in between, and changed in other colours.
  void start(Communicator& ranks, std::span<const Complex> by_slot, Index first, Index end);
  void finish(Communicator& ranks, std::span<Complex> by_slot, Index first, Index end);

  /// All colours, and no waiting for a better time.
  void exchange(Communicator& ranks, std::span<Complex> by_slot);

  /// How many ghosts there are.
  std::size_t ghost_count() const;

 private:
  struct Neighbor {
    int rank;
    CompressedRows<Index> sent, received;  ///< slots, a row a colour
    std::vector<Complex> out, in;          ///< beside their entries
  };
  Index color_count_ = 0;
  std::vector<Neighbor> neighbors_;
  std::vector<Outgoing> outgoing_;
  std::vector<Incoming> incoming_;
};

}  // namespace brindle
