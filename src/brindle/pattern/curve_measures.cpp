#include "brindle/curve_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/areas.h"
#include "brindle/geometry/nearest.h"

namespace brindle {
namespace {

constexpr std::size_t kPlaces = 100'000;

/// Segments as triangles without area, whose nearest places are those of the lines.
Mesh segments_of(const Polylines& lines) {
  Mesh mesh;
  mesh.positions = lines.points;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const Index first = lines.offsets[line], end = lines.offsets[line + 1];
    for (Index i = first; i + 1 < end; ++i) mesh.triangles.push_back({i, i + 1, i + 1});
    if (lines.closed[line]) mesh.triangles.push_back({end - 1, first, first});
  }
  return mesh;
}

/// The point of a triangle for two numbers that fill the unit square evenly.
Eigen::Vector3d point_in(const Mesh& mesh, const Triangle& triangle, double u, double v) {
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const Eigen::Vector3d a = mesh.positions[triangle[0]].cast<double>();
  const Eigen::Vector3d b = mesh.positions[triangle[1]].cast<double>();
  const Eigen::Vector3d c = mesh.positions[triangle[2]].cast<double>();
  return a + u * (b - a) + v * (c - a);
}

double fraction(double x) { return x - std::floor(x); }

/// The plastic number's reciprocals: no sequence in the square is known to be more even (Roberts
/// 2018).
Eigen::Vector3d place(const Mesh& mesh, std::span<const double> area_before, std::size_t k) {
  const double wanted =
      (static_cast<double>(k) + 0.5) / static_cast<double>(kPlaces) * area_before.back();
  const auto after = std::upper_bound(area_before.begin(), area_before.end() - 1, wanted);
  const auto t = static_cast<std::size_t>(
      std::max<std::ptrdiff_t>(0, std::distance(area_before.begin(), after) - 1));
  const auto number = static_cast<double>(k + 1);
  return point_in(mesh, mesh.triangles[std::min(t, mesh.triangle_count() - 1)],
                  fraction(number * 0.7548776662466927), fraction(number * 0.5698402909980532));
}

std::vector<double> areas_before(const Mesh& mesh) {
  std::vector<double> before = {0};
  for (const Triangle& t : mesh.triangles) {
    before.push_back(before.back() + static_cast<double>(triangle_area(mesh, t)));
  }
  return before;
}

}  // namespace

CurveLengths curve_lengths(const Polylines& lines) {
  CurveLengths lengths;
  lengths.shortest = lines.count() > 0 ? std::numeric_limits<double>::infinity() : 0;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const double length = length_of(lines, line);
    (lines.closed[line] ? lengths.closed_length : lengths.open_length) += length;
    ++(lines.closed[line] ? lengths.closed : lengths.open);
    lengths.shortest = std::min(lengths.shortest, length);
    lengths.longest = std::max(lengths.longest, length);
  }
  if (lines.count() > 0) {
    lengths.mean =
        (lengths.closed_length + lengths.open_length) / static_cast<double>(lines.count());
  }
  return lengths;
}

double curve_coverage(const Mesh& mesh, const Polylines& lines, double width) {
  if (!(width > 0) || !std::isfinite(width)) {
    throw Error("coverage: the width of a line must be a finite number above 0");
  }
  const std::vector<double> before = areas_before(mesh);
  if (lines.points.empty() || !(before.back() > 0)) return 0;
  const Mesh segments = segments_of(lines);
  const NearestOnMesh nearest(segments);
  const auto covered = parallel_sum<double>(kPlaces, [&](std::size_t begin, std::size_t end) {
    double count = 0;
    for (std::size_t k = begin; k < end; ++k) {
      count += nearest.nearest(place(mesh, before, k), width / 2).has_value();
    }
    return count;
  });
  return covered / static_cast<double>(kPlaces);
}

}  // namespace brindle
