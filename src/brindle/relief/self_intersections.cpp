#include "brindle/relief/self_intersections.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "brindle/base/parallel.h"
#include "brindle/geometry/box_tree.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

/// Tells sides of planes, apart from the rounding of coordinates.
class Sides {
 public:
  explicit Sides(const Mesh& mesh) {
    const BoundingBox box = bounding_box(mesh);
    rounding_ = 4e-7 * std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
  }

  /// Whether a segment crosses the inside of a triangle.
  bool cross(const Point& p, const Point& q, const std::array<Point, 3>& t) const {
    if (side(t[0], t[1], t[2], p) * side(t[0], t[1], t[2], q) >= 0) return false;
    const int first = side(p, q, t[0], t[1]);
    return first != 0 && side(p, q, t[1], t[2]) == first && side(p, q, t[2], t[0]) == first;
  }

 private:
  /// The sign of the volume of a tetrahedron; 0 within rounding.
  int side(const Point& a, const Point& b, const Point& c, const Point& p) const {
    const Point u = b - a, v = c - a;
    const double volume = u.cross(v).dot(p - a);
    const double rounding = rounding_ * u.norm() * v.norm();
    return volume > rounding ? 1 : volume < -rounding ? -1 : 0;
  }

  double rounding_;
};

std::array<Point, 3> points_of(const Mesh& mesh, Index t) {
  std::array<Point, 3> points;
  for (int m = 0; m < 3; ++m) points[m] = mesh.positions[mesh.triangles[t][m]].cast<double>();
  return points;
}

BoundingBox box_of_triangle(const Mesh& mesh, Index t) {
  const Triangle& c = mesh.triangles[t];
  const Vec3 &a = mesh.positions[c[0]], &b = mesh.positions[c[1]], &d = mesh.positions[c[2]];
  return {a.cwiseMin(b).cwiseMin(d), a.cwiseMax(b).cwiseMax(d)};
}

bool overlap(const BoundingBox& a, const BoundingBox& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

/// Whether an edge of triangle `t` crosses triangle `other`. Edges to a common vertex do not.
bool edge_crosses(const Mesh& mesh, const Sides& sides, Index t, Index other) {
  const Triangle &own = mesh.triangles[t], &theirs = mesh.triangles[other];
  const auto shared = [&](Index v) {
    return std::find(theirs.begin(), theirs.end(), v) != theirs.end();
  };
  const std::array<Point, 3> points = points_of(mesh, t), others = points_of(mesh, other);
  for (int m = 0; m < 3; ++m) {
    const int next = (m + 1) % 3;
    if (shared(own[m]) || shared(own[next])) continue;
    if (sides.cross(points[m], points[next], others)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::uint8_t> intersecting_triangles(const Mesh& mesh, const Progress& progress,
                                                 std::span<const std::uint8_t> tested) {
  const std::size_t count = mesh.triangle_count();
  std::vector<BoundingBox> boxes(count);
  parallel_for(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      boxes[t] = box_of_triangle(mesh, static_cast<Index>(t));
    }
  });
  const BoxTree tree(
      count, [&](Index t) { return boxes[t]; }, progress.part(0, 0.3));
  const Sides sides(mesh);
  std::vector<std::uint8_t> found(count);
  const auto test = [&](Index t) {
    const Point middle = boxes[t].center().cast<double>();
    tree.visit(
        middle,
        [&](const BoundingBox& box, double) { return found[t] == 0 && overlap(box, boxes[t]); },
        [&](Index other) {
          if (found[t] != 0 || other == t || !overlap(boxes[other], boxes[t])) return;
          found[t] = edge_crosses(mesh, sides, t, other) || edge_crosses(mesh, sides, other, t);
        });
  };
  parallel_for(
      count, progress.part(0.3, 1),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          if (tested.empty() || tested[t] != 0) test(static_cast<Index>(t));
        }
      },
      256);
  return found;
}

}  // namespace brindle
