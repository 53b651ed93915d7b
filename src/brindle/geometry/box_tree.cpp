#include "brindle/geometry/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

constexpr Index kLeafSize = 4;

/// Twice the centre of a box, which has the same order.
double doubled_center(const BoundingBox& box, Eigen::Index axis) {
  return static_cast<double>(box.lower[axis]) + static_cast<double>(box.upper[axis]);
}

}  // namespace

BoundingBox triangle_box(std::span<const Vec3> positions, const Triangle& triangle) {
  const Vec3 &a = positions[triangle[0]], &b = positions[triangle[1]], &c = positions[triangle[2]];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

BoundingBox around(const BoundingBox& a, const BoundingBox& b) {
  return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)};
}

bool overlap(const BoundingBox& a, const BoundingBox& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

double squared_distance(const BoundingBox& box, const Eigen::Vector3d& point) {
  const Eigen::Vector3d nearest =
      point.cwiseMax(box.lower.cast<double>()).cwiseMin(box.upper.cast<double>());
  return (nearest - point).squaredNorm();
}

void BoxTree::build(const std::vector<BoundingBox>& boxes, const Progress& progress) {
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), Index{0});
  if (boxes.empty()) return;
  nodes_.reserve(boxes.size());
  add_node(boxes, 0, static_cast<Index>(boxes.size()), progress);
}

/// Splits at the median, which bounds the depth for any input. Ties are broken by number, so that
/// the tree is the same on every machine.
void BoxTree::add_node(const std::vector<BoundingBox>& boxes, Index begin, Index end,
                       const Progress& progress) {
  if (end - begin >= kReportSlice) {
    progress.report(static_cast<double>(begin) / static_cast<double>(boxes.size()));
  }
  BoundingBox box = boxes[order_[begin]];
  for (Index i = begin + 1; i < end; ++i) box = around(box, boxes[order_[i]]);
  const std::size_t number = nodes_.size();
  nodes_.push_back({box, begin, end, 0});
  if (end - begin <= kLeafSize) return;
  Eigen::Index axis = 0;
  (box.upper - box.lower).maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index a, Index b) {
                     const double at_a = doubled_center(boxes[a], axis);
                     const double at_b = doubled_center(boxes[b], axis);
                     return at_a != at_b ? at_a < at_b : a < b;
                   });
  add_node(boxes, begin, middle, progress);
  nodes_[number].right = static_cast<Index>(nodes_.size());
  add_node(boxes, middle, end, progress);
}

void BoxTree::add_children(Index node, const Eigen::Vector3d& point, Pending& pending) const {
  Waiting nearer{node + 1, squared_distance(nodes_[node + 1].box, point)};
  Waiting farther{nodes_[node].right, squared_distance(nodes_[nodes_[node].right].box, point)};
  if (farther.square < nearer.square) std::swap(nearer, farther);
  pending.add(farther.node, farther.square);
  pending.add(nearer.node, nearer.square);
}

}  // namespace brindle
