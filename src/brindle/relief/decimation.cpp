#include "brindle/relief/decimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <Eigen/Dense>

#include "brindle/base/parallel.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

constexpr Index kNoCorner = kNoTriangle;
constexpr std::size_t kMostAround = 24;  // triangles at a vertex

using Point = Eigen::Vector3d;

/// The sum of squared distances from planes: p A p + 2 b p + c.
struct Quadric {
  std::array<double, 10> of = {};

  void add_plane(const Point& n, double d) {
    const std::array<double, 10> plane = {
        n.x() * n.x(), n.x() * n.y(), n.x() * n.z(), n.y() * n.y(), n.y() * n.z(),
        n.z() * n.z(), n.x() * d,     n.y() * d,     n.z() * d,     d * d};
    for (std::size_t i = 0; i < of.size(); ++i) of[i] += plane[i];
  }
  void add(const Quadric& other) {
    for (std::size_t i = 0; i < of.size(); ++i) of[i] += other.of[i];
  }
  double at(const Point& p) const {
    const double x = p.x(), y = p.y(), z = p.z();
    return x * (of[0] * x + 2 * (of[1] * y + of[2] * z + of[6])) +
           y * (of[3] * y + 2 * (of[4] * z + of[7])) + z * (of[5] * z + 2 * of[8]) + of[9];
  }
};

/// Collapses edges of a mesh whose corners are linked by vertex.
class Decimation {
 public:
  Decimation(const Mesh& mesh, std::span<const Vec3> rest, std::span<const std::uint8_t> locked,
             double narrowest)
      : narrowest_(narrowest),
        rest_(rest),
        triangles_(mesh.triangles),
        first_(mesh.vertex_count(), kNoCorner),
        next_(3 * mesh.triangle_count()),
        locked_(locked.begin(), locked.end()),
        quadrics_(mesh.vertex_count()),
        seen_(mesh.vertex_count()) {
    // Relative to a vertex: quadrics cancel far from zero.
    const Vec3 origin =
        mesh.triangles.empty() ? Vec3::Zero() : mesh.positions[mesh.triangles[0][0]];
    for (const Vec3& p : mesh.positions) positions_.push_back((p - origin).cast<double>());
    locked_.resize(mesh.vertex_count());
    lock_boundaries();
    for (Index c = 0; c < next_.size(); ++c) {
      Index& first = first_[vertex_at(triangles_, c)];
      next_[c] = std::exchange(first, c);
    }
    for (Index t = 0; t < triangles_.size(); ++t) add_plane_of(t);
  }

  /// Visits all vertices once. Returns the number of those removed.
  std::size_t sweep(double greatest_square, const Progress& progress) {
    std::size_t removed = 0;
    reported_for(first_.size(), progress, [&](std::size_t v) {
      if (locked_[v] == 0 && first_[v] != kNoCorner) {
        removed += remove(static_cast<Index>(v), greatest_square) ? 1 : 0;
      }
    });
    return removed;
  }

  std::vector<Triangle> take() {
    std::erase_if(triangles_, [](const Triangle& t) { return t[0] == t[1]; });
    return std::move(triangles_);
  }

 private:
  void lock_boundaries() {
    const std::vector<Index> twins = twins_of(triangles_);
    for (Index h = 0; h < twins.size(); ++h) {
      if (twins[h] != kNoTwin && twins[h] != kManyTwins) continue;
      locked_[vertex_at(triangles_, h)] = locked_[vertex_at(triangles_, next_in_triangle(h))] = 1;
    }
  }

  Point area_normal(const Triangle& t) const {
    return (positions_[t[1]] - positions_[t[0]]).cross(positions_[t[2]] - positions_[t[0]]);
  }
  Point rest_normal(const Triangle& t) const {
    const Point at = rest_[t[0]].cast<double>();
    return (rest_[t[1]].cast<double>() - at).cross(rest_[t[2]].cast<double>() - at);
  }

  /// Walls of bodies have no area before they are displaced.
  bool turns_at_rest(const Triangle& old, const Triangle& moved) const {
    const Point before = rest_normal(old);
    return before.squaredNorm() > 0 && turns(before, rest_normal(moved));
  }

  static bool turns(const Point& before, const Point& after) {
    constexpr double kCosine = 0.3;
    return !(after.dot(before) > kCosine * after.norm() * before.norm());
  }

  void add_plane_of(Index t) {
    const Point area = area_normal(triangles_[t]);
    if (!(area.norm() > 0)) return;
    const Point normal = area.normalized();
    for (const Index v : triangles_[t]) {
      quadrics_[v].add_plane(normal, -normal.dot(positions_[triangles_[t][0]]));
    }
  }

  template <class Body>
  void for_corners(Index v, const Body& body) const {
    for (Index c = first_[v]; c != kNoCorner; c = next_[c]) body(c);
  }

  bool remove(Index v, double greatest_square) {
    candidates_.clear();
    for_corners(v, [&](Index c) {
      const Index w = vertex_at(triangles_, next_in_triangle(c));
      const double square = quadrics_[v].at(positions_[w]);
      if (square <= greatest_square) candidates_.emplace_back(square, w);
    });
    if (candidates_.empty()) return false;
    ranges::sort(candidates_.begin(), candidates_.end());
    for (const auto& candidate : candidates_) {
      if (!may_move(v, candidate.second)) continue;
      move(v, candidate.second);
      return true;
    }
    return false;
  }

  /// Whether the surface keeps its topology and no triangle turns over.
  bool may_move(Index v, Index w) {
    std::size_t around = 0, at_w = 0, common = 0;
    bool spoilt = false;
    ++stamp_;
    for_corners(v, [&](Index c) {
      const Triangle& old = triangles_[c / 3];
      ++around;
      for (const Index other : old) seen_[other] = stamp_;
      if (std::find(old.begin(), old.end(), w) != old.end()) return;
      Triangle moved = old;
      moved[c % 3] = w;
      const Point before = area_normal(old), after = area_normal(moved);
      spoilt = spoilt || turns(before, after) || turns_at_rest(old, moved) ||
               narrow(moved, after) < std::min(narrow(old, before), narrowest_);
    });
    if (spoilt) return false;
    for_corners(w, [&](Index c) {
      ++at_w;
      const Index other = vertex_at(triangles_, next_in_triangle(c));
      common += other != v && seen_[other] == stamp_ ? 1 : 0;
    });
    return common == 2 && around + at_w <= kMostAround;
  }

  /// The smallest height of a triangle with this area normal.
  double narrow(const Triangle& t, const Point& area) const {
    double longest = 0;
    for (int m = 0; m < 3; ++m) {
      longest = std::max(longest, (positions_[t[m]] - positions_[t[(m + 1) % 3]]).norm());
    }
    return longest > 0 ? area.norm() / longest : 0;
  }

  void move(Index v, Index w) {
    for (Index c = first_[v]; c != kNoCorner;) {
      const Index next = next_[c];
      Triangle& triangle = triangles_[c / 3];
      if (std::find(triangle.begin(), triangle.end(), w) != triangle.end()) {
        drop(c / 3, v);
      } else {
        triangle[c % 3] = w;
        next_[c] = first_[w];
        first_[w] = c;
      }
      c = next;
    }
    first_[v] = kNoCorner;
    quadrics_[w].add(quadrics_[v]);
  }

  /// Removes a triangle from the lists of all its vertices but `v`.
  void drop(Index t, Index v) {
    for (int m = 0; m < 3; ++m) {
      const Index other = triangles_[t][m];
      if (other == v) continue;
      Index* link = &first_[other];
      while (*link != 3 * t + static_cast<Index>(m)) link = &next_[*link];
      *link = next_[*link];
    }
    triangles_[t] = {0, 0, 0};
  }

  double narrowest_;  // new triangles are as high, or as their predecessors
  std::span<const Vec3> rest_;
  std::vector<Triangle> triangles_;  // removed ones have equal corners
  std::vector<Index> first_, next_;  // corners at a vertex
  std::vector<std::uint8_t> locked_;
  std::vector<Point> positions_;
  std::vector<Quadric> quadrics_;
  std::vector<std::uint64_t> seen_;  // the last test of a vertex
  std::uint64_t stamp_ = 0;
  std::vector<std::pair<double, Index>> candidates_;
};

}  // namespace

std::vector<Triangle> decimated(const Mesh& mesh, std::span<const Vec3> rest,
                                std::span<const std::uint8_t> locked, float tolerance,
                                const Progress& progress) {
  Decimation decimation(mesh, rest, locked, tolerance);
  const double square = static_cast<double>(tolerance) * tolerance;
  // Small errors first, without a queue: what flat parts spare does not depend on the order.
  const std::array<double, 5> shares = {1e-6, 1e-6, 0.05, 1, 1};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double done = static_cast<double>(i) / shares.size();
    decimation.sweep(shares[i] * square, progress.part(done, done + 1.0 / shares.size()));
  }
  return decimation.take();
}

}  // namespace brindle
