#include <Eigen/Geometry>

#include "brindle/mesh.h"

namespace brindle {
namespace {

constexpr std::size_t kMostClipped = 1000;  // clipping takes the square of the corners
/// The most tests of corners, in multiples of that square. Polygons that cross themselves
/// everywhere would need the cube; any cuts of theirs are as good.
constexpr std::size_t kMostLooks = 8;

using Point = Eigen::Vector3d;

/// A polygon's corners seen along its mean normal (Newell's method).
struct Outline {
  std::vector<Point> points;
  Point normal = Point::Zero();

  Outline(std::span<const Vec3> positions, std::span<const Index> corners) {
    for (const Index corner : corners) points.push_back(positions[corner].cast<double>());
    for (std::size_t i = 0; i < points.size(); ++i) {
      normal += (points[i] - points[0]).cross(points[(i + 1) % points.size()] - points[0]);
    }
  }

  /// Twice the signed area of a triangle of corners, times the normal's length.
  double area(std::size_t a, std::size_t b, std::size_t c) const {
    return (points[b] - points[a]).cross(points[c] - points[a]).dot(normal);
  }
};

/// Whether `b` can be cut off: it is convex, and no other corner lies in its triangle. Subtracts
/// its tests from `looks`.
bool is_ear(const Outline& outline, const std::vector<std::size_t>& left, std::size_t at,
            std::size_t& looks) {
  if (looks > 0) --looks;
  const std::size_t n = left.size();
  const std::size_t a = left[(at + n - 1) % n], b = left[at], c = left[(at + 1) % n];
  if (!(outline.area(a, b, c) > 0)) return false;
  for (const std::size_t p : left) {
    if (looks > 0) --looks;
    if (p == a || p == b || p == c) continue;
    if (outline.area(a, b, p) >= 0 && outline.area(b, c, p) >= 0 && outline.area(c, a, p) >= 0) {
      return false;
    }
  }
  return true;
}

void clip_ears(const Outline& outline, std::span<const Index> corners,
               std::vector<Triangle>& triangles) {
  std::vector<std::size_t> left(corners.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::size_t at = 1, looks = kMostLooks * left.size() * left.size();
  while (left.size() > 3) {
    const std::size_t n = left.size();
    std::size_t tried = 0;
    while (tried < n && looks > 0 && !is_ear(outline, left, at % n, looks)) {
      ++at;
      ++tried;
    }
    // Without an ear the polygon crosses itself or is flat: any cut is as good.
    at %= n;
    triangles.push_back(
        {corners[left[(at + n - 1) % n]], corners[left[at]], corners[left[(at + 1) % n]]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    // Not the neighbour of the cut at once: that would make a fan of slivers.
    ++at;
  }
  triangles.push_back({corners[left[0]], corners[left[1]], corners[left[2]]});
}

void cut_quadrangle(const Outline& outline, std::span<const Index> corners,
                    std::vector<Triangle>& triangles) {
  const auto inner = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return outline.area(a, b, c) > 0 && outline.area(a, c, d) > 0;
  };
  const double first = (outline.points[2] - outline.points[0]).squaredNorm();
  const double second = (outline.points[3] - outline.points[1]).squaredNorm();
  const bool take_second =
      inner(0, 1, 2, 3) ? inner(1, 2, 3, 0) && second < first : inner(1, 2, 3, 0);
  if (take_second) {
    triangles.push_back({corners[0], corners[1], corners[3]});
    triangles.push_back({corners[1], corners[2], corners[3]});
  } else {
    triangles.push_back({corners[0], corners[1], corners[2]});
    triangles.push_back({corners[0], corners[2], corners[3]});
  }
}

}  // namespace

void triangulate_polygon(std::span<const Vec3> positions, std::span<const Index> corners,
                         std::vector<Triangle>& triangles) {
  if (corners.size() < 3) return;
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
  } else if (corners.size() == 4) {
    cut_quadrangle(Outline(positions, corners), corners, triangles);
  } else if (corners.size() <= kMostClipped) {
    clip_ears(Outline(positions, corners), corners, triangles);
  } else {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      triangles.push_back({corners[0], corners[i], corners[i + 1]});
    }
  }
}

}  // namespace brindle
