#include "gallery/vascular_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brindle/base/elementary.h"
#include "brindle/base/random.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

struct Node {
  Point at;
  int parent = -1;
  int leaves = 0;  // in its subtree
};

class Growth {
 public:
  Growth(const VascularTree& tree, std::vector<Point> places)
      : tree_(tree), places_(std::move(places)), nearest_(places_.size(), 0) {
    nodes_.push_back({tree.root});
    const int pieces = std::max(1, static_cast<int>(std::lround(tree.trunk / tree.step)));
    for (int k = 1; k <= pieces; ++k) add(tree.root + k * tree.step * tree.direction, k - 1);
  }

  std::vector<Node> grown() {
    constexpr int kMostRounds = 400;
    for (int round = 0; round < kMostRounds && !places_.empty(); ++round) {
      if (!grow()) break;
    }
    drop_stubs();
    smooth();
    count_leaves();
    return std::move(nodes_);
  }

 private:
  void add(const Point& at, int parent) {
    nodes_.push_back({at, parent});
    const auto node = static_cast<int>(nodes_.size() - 1);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if ((places_[i] - at).squaredNorm() < (places_[i] - nodes_[nearest_[i]].at).squaredNorm()) {
        nearest_[i] = node;
      }
    }
  }

  // Moves each node that is nearest to some points towards these by a step.
  bool grow() {
    std::vector<Point> pull(nodes_.size(), Point::Zero());
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const int node = nearest_[i];
      pull[node] += (places_[i] - nodes_[node].at).normalized();
    }
    const std::size_t before = nodes_.size();
    for (std::size_t node = 0; node < before; ++node) {
      if (pull[node].norm() < 1e-3) continue;
      const Point to = nodes_[node].at + tree_.step * heading(node, pull[node]);
      const bool there = std::ranges::any_of(
          nodes_, [&](const Node& other) { return (other.at - to).norm() < 0.3 * tree_.step; });
      if (!there) add(to, static_cast<int>(node));
    }
    drop_reached();
    return nodes_.size() > before;
  }

  // Vessels bend without kinks.
  Point heading(std::size_t node, const Point& pull) const {
    Point direction = pull.normalized();
    const int parent = nodes_[node].parent;
    if (parent >= 0) direction += 0.45 * (nodes_[node].at - nodes_[parent].at).normalized();
    return direction.normalized();
  }

  void drop_reached() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if ((places_[i] - nodes_[nearest_[i]].at).norm() < 3.2 * tree_.step) continue;
      places_[kept] = places_[i];
      nearest_[kept++] = nearest_[i];
    }
    places_.resize(kept);
    nearest_.resize(kept);
  }

  // Removes short branches, which reach for a point beside a vessel.
  void drop_stubs() {
    constexpr int kStub = 4;                     // segments
    std::vector<int> longest(nodes_.size(), 0);  // segments behind a node
    for (std::size_t i = nodes_.size(); i-- > 1;) {
      longest[nodes_[i].parent] = std::max(longest[nodes_[i].parent], longest[i] + 1);
    }
    std::vector<int> number(nodes_.size(), -1);
    std::vector<Node> kept;
    std::vector<char> continued(nodes_.size(), 0);  // nodes whose vessel continues in a child
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      Node node = nodes_[i];
      if (node.parent >= 0) {
        const int parent = node.parent;
        const bool on = !continued[parent] && longest[i] + 1 == longest[parent];
        continued[parent] |= on;
        if (number[parent] < 0 || (!on && longest[i] + 1 < kStub)) continue;
        node.parent = number[parent];
      }
      number[i] = static_cast<int>(kept.size());
      kept.push_back(node);
    }
    nodes_ = std::move(kept);
  }

  void smooth() {
    std::vector<Point> sum(nodes_.size());
    std::vector<int> count(nodes_.size());
    for (int round = 0; round < 3; ++round) {
      std::ranges::fill(sum, Point::Zero());
      std::ranges::fill(count, 0);
      for (std::size_t i = 1; i < nodes_.size(); ++i) {
        const int parent = nodes_[i].parent;
        sum[parent] += nodes_[i].at;
        ++count[parent];
      }
      for (std::size_t i = 1; i < nodes_.size(); ++i) {
        if (count[i] == 0) continue;
        const Point middle = 0.5 * (sum[i] / count[i] + nodes_[nodes_[i].parent].at);
        nodes_[i].at = 0.5 * (nodes_[i].at + middle);
      }
    }
  }

  void count_leaves() {
    for (std::size_t i = nodes_.size(); i-- > 1;) {
      nodes_[i].leaves = std::max(nodes_[i].leaves, 1);
      nodes_[nodes_[i].parent].leaves += nodes_[i].leaves;
    }
  }

  const VascularTree& tree_;
  std::vector<Point> places_;
  std::vector<int> nearest_;  // node of every point
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<Capsule> grow_vessels(const VascularTree& tree, const std::vector<Point>& places) {
  const std::vector<Node> nodes = Growth(tree, places).grown();
  const auto radius = [&](const Node& node) {
    const double share = static_cast<double>(node.leaves) / nodes.front().leaves;
    return std::max(tree.radius * elementary::cbrt(share), tree.thinnest);
  };
  std::vector<Capsule> vessels;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    // A branch starts with its own radius.
    const double thick = radius(nodes[i]);
    vessels.push_back({nodes[nodes[i].parent].at, nodes[i].at, thick, thick});
  }
  return vessels;
}

std::vector<Point> scattered_places(const Point& lower, const Point& upper, int count,
                                    std::uint32_t seed,
                                    const std::function<bool(const Point&)>& inside) {
  constexpr int kCandidates = 6;
  std::vector<Point> places;
  std::uint64_t drawn = 0;
  const auto random_place = [&]() -> Point {
    for (;;) {
      Point p;
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = lower[axis] + (upper[axis] - lower[axis]) * random_number(seed, drawn++);
      }
      if (inside(p)) return p;
    }
  };
  const auto room = [&](const Point& p) {
    double nearest = std::numeric_limits<double>::max();
    for (const Point& other : places) nearest = std::min(nearest, (other - p).squaredNorm());
    return nearest;
  };
  for (int i = 0; i < count; ++i) {
    Point best = random_place();
    for (int k = 1; k < kCandidates; ++k) {
      const Point other = random_place();
      if (room(other) > room(best)) best = other;
    }
    places.push_back(best);
  }
  return places;
}

}  // namespace brindle
