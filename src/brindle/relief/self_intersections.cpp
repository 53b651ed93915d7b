#include "brindle/relief/self_intersections.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>
#include <utility>

#include <Eigen/Dense>

#include "brindle/base/parallel.h"
#include "brindle/geometry/box_tree.h"

namespace brindle {
namespace {

__extension__ typedef __int128 Whole;
using Point = Eigen::Vector3d;  // of whole numbers up to 2^40 in size

/// The sign of the volume of a tetrahedron. Differences of coordinates are exact in doubles, the
/// volume in 128 bits.
int side(const Point& a, const Point& b, const Point& c, const Point& p) {
  const Point u = a - p, v = b - p, w = c - p;
  const double volume = u.dot(v.cross(w));
  const Point sizes(std::abs(v.y() * w.z()) + std::abs(v.z() * w.y()),
                    std::abs(v.z() * w.x()) + std::abs(v.x() * w.z()),
                    std::abs(v.x() * w.y()) + std::abs(v.y() * w.x()));
  constexpr double kRounding = 0x1p-50;  // above (7 + 56 e) e with e = 2^-53 (Shewchuk 1997)
  const double error = kRounding * u.cwiseAbs().dot(sizes);
  if (std::abs(volume) > error) return volume > 0 ? 1 : -1;
  if (error == 0) return 0;
  const auto minor = [&](int i, int j) {
    return static_cast<Whole>(v[i]) * static_cast<Whole>(w[j]) -
           static_cast<Whole>(v[j]) * static_cast<Whole>(w[i]);
  };
  const Whole exact = static_cast<Whole>(u.x()) * minor(1, 2) +
                      static_cast<Whole>(u.y()) * minor(2, 0) +
                      static_cast<Whole>(u.z()) * minor(0, 1);
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

/// A triangle, and which of its corners another one has, too.
struct Side {
  std::array<Point, 3> points;
  std::array<bool, 3> shared;
  std::array<int, 3> beyond = {};  // the other's plane; 0 for shared corners

  void compare(const Side& other) {
    const auto& [a, b, c] = other.points;
    for (int m = 0; m < 3; ++m) beyond[m] = shared[m] ? 0 : side(a, b, c, points[m]);
  }
  /// Whether all corners but shared ones are strictly on one side.
  bool is_apart() const {
    int sum = 0, own = 0;
    for (int m = 0; m < 3; ++m) {
      sum += beyond[m];
      own += shared[m] ? 0 : 1;
    }
    return std::abs(sum) == own;
  }
  /// Whether an edge crosses the other triangle. Edges to shared corners do not.
  bool crosses(const Side& other) const {
    const auto& [a, b, c] = other.points;
    for (int m = 0; m < 3; ++m) {
      const int next = (m + 1) % 3;
      if (beyond[m] * beyond[next] >= 0) continue;
      const Point &p = points[m], &q = points[next];
      const std::array<int, 3> around = {side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)};
      const auto [least, most] = std::minmax_element(around.begin(), around.end());
      if (*least >= 0 || *most <= 0) return true;
    }
    return false;
  }
  Point normal() const { return (points[1] - points[0]).cross(points[2] - points[0]); }
};

/// Finds intersections while vertices move.
class IntersectionFinder {
 public:
  /// Triangles stay in boxes, so that the tree holds for all tests.
  template <class BoxOf>
  IntersectionFinder(std::span<const Triangle> triangles, const BoxOf& box_of,
                     const Progress& progress)
      : triangles_(triangles), tree_(triangles.size(), box_of, progress) {}

  /// Compares triangles with a 1 in `tested` with all others; empty: all.
  std::vector<std::uint8_t> find(std::span<const Vec3> positions,
                                 std::span<const std::uint8_t> tested, const Progress& progress) {
    place(positions);
    std::vector<std::atomic<std::uint8_t>> found(triangles_.size());
    const auto is_tested = [&](std::size_t t) { return tested.empty() || tested[t] != 0; };
    const auto test = [&](Index t) {
      tree_.visit(
          boxes_[t].center().cast<double>(),
          [&](const BoundingBox& box, double) { return overlap(box, boxes_[t]); },
          [&](Index other) {
            const bool is_done = other == t || (other < t && is_tested(other));
            if (is_done || !overlap(boxes_[other], boxes_[t]) || !intersect(t, other)) return;
            found[t].store(1, std::memory_order_relaxed);
            found[other].store(1, std::memory_order_relaxed);
          });
    };
    parallel_for(
        found.size(), progress,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t t = begin; t < end; ++t) {
            if (is_tested(t)) test(static_cast<Index>(t));
          }
        },
        256);
    return {found.begin(), found.end()};
  }

 private:
  /// Coordinates as whole numbers, and boxes.
  void place(std::span<const Vec3> positions) {
    float largest = 0;
    for (const Vec3& p : positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    constexpr int kBits = 40;  // the volume has 3 * 40 + 6
    const double scale = std::ldexp(1.0, kBits - (largest > 0 ? std::ilogb(largest) + 1 : 0));
    points_.resize(positions.size());
    boxes_.resize(triangles_.size());
    parallel_for(points_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        points_[v] = (scale * positions[v].cast<double>()).array().round().matrix();
      }
    });
    parallel_for(boxes_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        boxes_[t] = triangle_box(positions, triangles_[t]);
      }
    });
  }

  Side side_of(Index t, const Triangle& other) const {
    Side side;
    for (int m = 0; m < 3; ++m) {
      const Index v = triangles_[t][m];
      side.points[m] = points_[v];
      side.shared[m] = v == other[0] || v == other[1] || v == other[2];
    }
    return side;
  }

  bool intersect(Index t, Index u) const {
    Side one = side_of(t, triangles_[u]), two = side_of(u, triangles_[t]);
    one.compare(two);
    if (one.is_apart()) return false;
    two.compare(one);
    if (two.is_apart()) return false;
    if (one.crosses(two) || two.crosses(one)) return true;
    // Neighbours in one plane, whose common edge they run along in opposite directions.
    return ranges::count(one.shared, true) == 2 && one.normal().dot(two.normal()) < 0;
  }

  std::span<const Triangle> triangles_;
  BoxTree tree_;
  std::vector<Point> points_;
  std::vector<BoundingBox> boxes_;  // of triangles
};

/// Lowers the vertices of triangles with a 1. Returns 1 for triangles that move; empty: none do.
std::vector<std::uint8_t> lower(RaisedMesh& mesh, const std::vector<std::uint8_t>& found,
                                std::span<const float> least, float share) {
  std::vector<std::uint8_t> lowered(mesh.rest.size());
  for (std::size_t t = 0; t < found.size(); ++t) {
    if (found[t] == 0) continue;
    for (const Index v : mesh.triangles[t]) lowered[v] = mesh.heights[v] > least[v] ? 1 : 0;
  }
  if (ranges::find(lowered, std::uint8_t{1}) == lowered.end()) return {};
  for (std::size_t v = 0; v < lowered.size(); ++v) {
    if (lowered[v] != 0) mesh.heights[v] = std::max(least[v], share * mesh.heights[v]);
  }
  std::vector<std::uint8_t> moved(found.size());
  for (std::size_t t = 0; t < moved.size(); ++t) {
    for (const Index v : mesh.triangles[t]) moved[t] |= lowered[v];
  }
  return moved;
}

std::size_t count_of(const std::vector<std::uint8_t>& found) {
  return static_cast<std::size_t>(ranges::count(found, std::uint8_t{1}));
}

}  // namespace

std::vector<std::uint8_t> intersecting_triangles(const Mesh& mesh, const Progress& progress) {
  IntersectionFinder finder(
      mesh.triangles, [&](Index t) { return triangle_box(mesh.positions, mesh.triangles[t]); },
      progress.part(0, 0.3));
  return finder.find(mesh.positions, {}, progress.part(0.3, 1));
}

std::vector<Vec3> RaisedMesh::positions() const {
  std::vector<Vec3> positions(rest.size());
  for (std::size_t v = 0; v < rest.size(); ++v) positions[v] = rest[v] + heights[v] * ways[v];
  return positions;
}

std::size_t lower_intersections(RaisedMesh& mesh, const Progress& progress) {
  constexpr int kHalvings = 4;
  std::vector<float> least = mesh.heights;
  for (float& height : least) height *= mesh.least_share;
  std::vector<Vec3> positions = mesh.positions();
  IntersectionFinder finder(
      mesh.triangles,
      [&](Index t) {
        return around(triangle_box(positions, mesh.triangles[t]),
                      triangle_box(mesh.rest, mesh.triangles[t]));
      },
      progress.part(0, 0.3));
  std::vector<std::uint8_t> found = finder.find(positions, {}, progress.part(0.3, 0.9));
  if (count_of(found) == 0) return 0;
  for (int round = 0;; ++round) {
    const auto moved = lower(mesh, found, least, round < kHalvings ? 0.5f : 0.0f);
    if (moved.empty()) break;
    progress.tick();
    positions = mesh.positions();
    found = finder.find(positions, moved, {});
  }
  // Triangles that were found before others moved may intersect still.
  return count_of(finder.find(positions, {}, progress.part(0.9, 1)));
}

}  // namespace brindle
