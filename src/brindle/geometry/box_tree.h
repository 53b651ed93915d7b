/// A tree of bounding boxes, to find the nearest of numbered items.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

BoundingBox triangle_box(std::span<const Vec3> positions, const Triangle& triangle);

/// The smallest box around two.
BoundingBox around(const BoundingBox& a, const BoundingBox& b);

/// Whether two boxes have a point in common.
bool overlap(const BoundingBox& a, const BoundingBox& b);

/// The squared distance of a point from a box; 0 inside.
double squared_distance(const BoundingBox& box, const Eigen::Vector3d& point);

/// A binary tree over the boxes of numbered items. A node covers a range of `order_`, its children
/// the two halves.
class BoxTree {
 public:
  /// `box_of(number)` is the bounding box of an item, with finite corners. Throws Cancelled if
  /// `progress` asks for it.
  template <class BoxOf>
  BoxTree(std::size_t count, const BoxOf& box_of, const Progress& progress = {}) {
    std::vector<BoundingBox> boxes(count);
    for (std::size_t i = 0; i < count; ++i) boxes[i] = box_of(static_cast<Index>(i));
    build(boxes, progress);
  }

  struct Found {
    Index number;
    double square;  ///< of the distance
  };

  /// The item with the smallest `square_of(number)`, its squared distance from `point`; ties go to
  /// the smallest number. Nullopt if all exceed `limit`, also a squared distance. No item may be
  /// nearer than its box.
  template <class SquareOf>
  std::optional<Found> nearest(const Eigen::Vector3d& point, double limit,
                               const SquareOf& square_of) const {
    // Boxes as near as the best count too, despite rounding.
    constexpr double kJustAsNear = 1 + 8 * std::numeric_limits<double>::epsilon();
    std::optional<Found> best;
    Pending pending;
    if (!nodes_.empty()) pending.add(0, squared_distance(nodes_[0].box, point));
    while (pending.count > 0) {
      const Waiting next = pending.take();
      if (next.square > kJustAsNear * (best ? best->square : limit)) continue;
      const Node& node = nodes_[next.node];
      if (node.right != 0) {
        add_children(next.node, point, pending);
        continue;
      }
      for (Index i = node.begin; i < node.end; ++i) {
        const Found here{order_[i], square_of(order_[i])};
        if (best ? is_before(here, *best) : here.square <= limit) best = here;
      }
    }
    return best;
  }

  /// Calls `take(number)` for all items in boxes for which `may_count(box, square)` holds; `square`
  /// is the box's squared distance. Visits the nearer child first, so that items found may exclude
  /// others.
  template <class MayCount, class Take>
  void visit(const Eigen::Vector3d& point, const MayCount& may_count, const Take& take) const {
    Pending pending;
    if (!nodes_.empty()) pending.add(0, squared_distance(nodes_[0].box, point));
    while (pending.count > 0) {
      const Waiting next = pending.take();
      const Node& node = nodes_[next.node];
      if (!may_count(node.box, next.square)) continue;
      if (node.right != 0) {
        add_children(next.node, point, pending);
      } else {
        for (Index i = node.begin; i < node.end; ++i) take(order_[i]);
      }
    }
  }

 private:
  struct Node {
    BoundingBox box;
    Index begin = 0, end = 0;  ///< range of `order_`
    Index right = 0;           ///< second child; the first one follows its parent; 0: leaf
  };

  struct Waiting {
    Index node;
    double square;  ///< of the distance of its box
  };

  /// Stack of nodes to search. Ranges are halved, so there are fewer levels than bits in an Index.
  /// Each level leaves at most one waiting node, the last one two.
  struct Pending {
    std::array<Waiting, 8 * sizeof(Index) + 1> nodes;
    std::size_t count = 0;

    void add(Index node, double square) { nodes[count++] = {node, square}; }
    Waiting take() { return nodes[--count]; }
  };

  static bool is_before(const Found& a, const Found& b) {
    return a.square != b.square ? a.square < b.square : a.number < b.number;
  }
  /// Adds the nearer child last, so that it is taken first.
  void add_children(Index node, const Eigen::Vector3d& point, Pending& pending) const;
  void build(const std::vector<BoundingBox>& boxes, const Progress& progress);
  void add_node(const std::vector<BoundingBox>& boxes, Index begin, Index end,
                const Progress& progress);

  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace brindle
