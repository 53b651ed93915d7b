#include "brindle/polylines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brindle/error.h"

namespace brindle {
namespace {

void append(Polylines& lines, const Vec3& point, const Vec3& normal) {
  lines.points.push_back(point);
  lines.normals.push_back(normal);
}

void end_line(Polylines& lines, bool closed) {
  lines.offsets.push_back(static_cast<Index>(lines.points.size()));
  lines.closed.push_back(closed);
}

/// Marks the points to keep between `first` and `last`, which are kept. `last` may be the number of
/// points, for the first one of a closed line.
void keep_farthest(std::span<const Vec3> points, std::size_t first, std::size_t last,
                   float tolerance, std::vector<std::uint8_t>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    float farthest = tolerance;
    std::size_t at = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const float d = distance_to_segment(points[i], points[from], points[to % points.size()]);
      if (d > farthest) farthest = d, at = i;
    }
    if (at == 0) continue;
    keep[at] = 1;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
}

std::size_t farthest_from_first(std::span<const Vec3> points) {
  const auto farther = [&](const Vec3& a, const Vec3& b) {
    return (a - points[0]).squaredNorm() < (b - points[0]).squaredNorm();
  };
  return static_cast<std::size_t>(std::max_element(points.begin(), points.end(), farther) -
                                  points.begin());
}

/// The place at the share `t` of the way along the segment that starts at a point.
TrianglePoint place_on(const Polylines& lines, std::size_t point, double t) {
  TrianglePoint place = lines.places[point];
  for (std::size_t m = 0; m < 3; ++m) {
    place.barycentric[m] += t * (lines.arrivals[point][m] - place.barycentric[m]);
  }
  return place;
}

/// Whole steps along a line of some length: one at least, of a closed line three.
std::size_t steps_along(double length, float spacing, bool closed) {
  const double steps = std::max(std::round(length / spacing), closed ? 3.0 : 1.0);
  if (!(steps < 4e9)) throw Error("a curve would get too many points; choose a larger spacing");
  return static_cast<std::size_t>(steps);
}

}  // namespace

float distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const float square = along.squaredNorm();
  const float t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0f, 1.0f) : 0.0f;
  return (p - a - t * along).norm();
}

double length_of(const Polylines& lines, std::size_t line) {
  const auto points = lines.points_of(line);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  if (lines.closed[line] && !points.empty()) length += (points.front() - points.back()).norm();
  return length;
}

Polylines simplified(const Polylines& lines, float tolerance) {
  Polylines result;
  result.origin = lines.origin;
  std::vector<std::uint8_t> keep;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto points = lines.points_of(line);
    keep.assign(points.size(), 0);
    keep.front() = 1;
    if (lines.closed[line]) {
      const std::size_t far = farthest_from_first(points);
      keep[far] = 1;
      keep_farthest(points, 0, far, tolerance, keep);
      keep_farthest(points, far, points.size(), tolerance, keep);
    } else {
      keep.back() = 1;
      keep_farthest(points, 0, points.size() - 1, tolerance, keep);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!keep[i]) continue;
      append(result, points[i], lines.normals_of(line)[i]);
      if (!lines.places.empty()) result.places.push_back(lines.places[lines.offsets[line] + i]);
    }
    end_line(result, lines.closed[line]);
  }
  return result;
}

Polylines resampled(const Polylines& lines, float spacing) {
  if (!(spacing > 0)) throw Error("the spacing of points along curves must be above zero");
  Polylines result;
  result.origin = lines.origin;
  const bool placed = !lines.arrivals.empty();
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto points = lines.points_of(line);
    const auto normals = lines.normals_of(line);
    const double length = length_of(lines, line);
    const bool closed = lines.closed[line];
    const std::size_t steps = steps_along(length, spacing, closed);
    if (result.points.size() + steps > 0xfffffff0) {
      throw Error("curves would get too many points; choose a larger spacing");
    }
    std::size_t segment = 0;
    double passed = 0;  // up to the segment's start
    for (std::size_t step = 0; step < steps; ++step) {
      const double goal = length * static_cast<double>(step) / static_cast<double>(steps);
      const auto end = [&] { return (segment + 1) % points.size(); };
      double size = (points[end()] - points[segment]).norm();
      while (passed + size < goal && segment + 2 < points.size() + closed) {
        passed += size;
        ++segment;
        size = (points[end()] - points[segment]).norm();
      }
      const float t = size > 0 ? static_cast<float>(std::min((goal - passed) / size, 1.0)) : 0.0f;
      const Vec3 normal = (1 - t) * normals[segment] + t * normals[end()];
      append(result, points[segment] + t * (points[end()] - points[segment]),
             normal.stableNormalized());
      if (placed) result.places.push_back(place_on(lines, lines.offsets[line] + segment, t));
    }
    if (!closed) {
      append(result, points.back(), normals.back());
      if (placed) result.places.push_back(lines.places[lines.offsets[line + 1] - 1]);
    }
    end_line(result, closed);
  }
  return result;
}

}  // namespace brindle
