#include "brindle/curve_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/nearest.h"

namespace brindle {
namespace {

/// Segments as degenerate triangles, for nearest-point queries.
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

/// Maps a point of the unit square to a triangle; evenly distributed points stay even.
Eigen::Vector3d point_in(const Mesh& mesh, const Triangle& triangle, double u, double v) {
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const Eigen::Vector3d a = mesh.positions[triangle[0]].cast<double>();
  const Eigen::Vector3d b = mesh.positions[triangle[1]].cast<double>();
  const Eigen::Vector3d c = mesh.positions[triangle[2]].cast<double>();
  return a + u * (b - a) + v * (c - a);
}

constexpr std::size_t kCoveragePlaces = 100'000;

double fraction(double x) { return x - std::floor(x); }

std::vector<double> areas_before(const Mesh& mesh) {
  std::vector<double> before = {0};
  for (const Triangle& t : mesh.triangles) {
    before.push_back(before.back() + static_cast<double>(triangle_area(mesh, t)));
  }
  return before;
}

/// Sample k, in the triangle at the cumulative area `wanted`. Reciprocals of the plastic number
/// give the most even known sequence in the square (Roberts 2018).
Eigen::Vector3d place_at(const Mesh& mesh, std::span<const double> area_before, double wanted,
                         std::size_t k) {
  const auto after = std::upper_bound(area_before.begin(), area_before.end() - 1, wanted);
  const auto t = static_cast<std::size_t>(
      std::max<std::ptrdiff_t>(0, std::distance(area_before.begin(), after) - 1));
  const auto number = static_cast<double>(k + 1);
  return point_in(mesh, mesh.triangles[std::min(t, mesh.triangle_count() - 1)],
                  fraction(number * 0.7548776662466927), fraction(number * 0.5698402909980532));
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

namespace {

/// Whether a second line lies within `reach` of a place, on the side away from the nearest line.
/// Queries the point nearest to the far end of that range.
bool has_line_beyond(const NearestOnMesh& nearest, const Eigen::Vector3d& place,
                     const Eigen::Vector3d& nearest_to_it, double reach) {
  const Eigen::Vector3d to_it = nearest_to_it - place;
  if (!(to_it.norm() > 0)) return false;
  const Eigen::Vector3d away = -to_it.normalized();
  const auto other = nearest.nearest(place + reach * away, reach);
  if (!other) return false;
  const Eigen::Vector3d to_other = other->position - place;
  return to_other.dot(away) > 0 && to_other.norm() <= reach;
}

struct Covered {
  double once = 0, twice = 0;
  Covered operator+(const Covered& other) const { return {once + other.once, twice + other.twice}; }
};

}  // namespace

void check_line_width(double width) {
  if (width > 0 && std::isfinite(width)) return;
  throw Error("coverage: the width of a line must be a finite number above 0");
}

CurveCoverage measure_coverage(const Mesh& mesh, const Polylines& lines, double width,
                               const Progress& progress) {
  check_line_width(width);
  const std::vector<double> area_before = areas_before(mesh);
  const double area = area_before.back();
  if (lines.points.empty() || !(area > 0)) return {};
  constexpr auto kAll = static_cast<double>(kCoveragePlaces);
  std::vector<Eigen::Vector3d> places;
  for (std::size_t k = 0; k < kCoveragePlaces; ++k) {
    places.push_back(place_at(mesh, area_before, (static_cast<double>(k) + 0.5) / kAll * area, k));
  }
  const Mesh segments = segments_of(lines);
  JobStages stages(progress, {{"nearest places", 1}, {"coverage", 1}});
  const NearestOnMesh nearest(segments, stages.begin("nearest places"));
  const auto covered = parallel_sum<Covered>(
      places.size(), stages.begin("coverage"), [&](std::size_t begin, std::size_t end) {
        Covered count;
        for (std::size_t k = begin; k < end; ++k) {
          const auto found = nearest.nearest(places[k], width / 2);
          if (!found) continue;
          ++count.once;
          count.twice += has_line_beyond(nearest, places[k], found->position, width / 2);
        }
        return count;
      });
  stages.finish();
  return {covered.once / kAll, covered.twice / kAll};
}

double curve_coverage(const Mesh& mesh, const Polylines& lines, double width,
                      const Progress& progress) {
  return measure_coverage(mesh, lines, width, progress).once;
}

}  // namespace brindle
