#include "brindle/pattern/curve_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "brindle/base/moments.h"
#include "brindle/base/parallel.h"
#include "brindle/points/point_tree.h"

namespace brindle {
namespace {

constexpr float kNeighborReach = 1.6f;  // how far a neighbour is looked for, times 1/f
constexpr float kGapReach = 2.5f;       // beside a branch, the next curve but one is in reach
constexpr float kStep = 0.2f;           // between points, times 1/f
constexpr float kAslant = 0.24f;  // sine: points are close enough for one to be that much aside

/// Points along all curves, with what a measurement needs to know.
struct Marks {
  Polylines lines;
  std::vector<Vec3> along;                     ///< the curve's direction, one per point
  std::vector<float> frequencies;              ///< one per point
  std::vector<std::array<Index, 2>> adjacent;  ///< points before and behind on the curve
};

/// The distance between points that is small enough everywhere.
float step_along(const WavePattern& pattern) {
  const auto& frequencies = pattern.waves.frequencies;
  if (frequencies.empty()) return 1;
  return kStep / *std::max_element(frequencies.begin(), frequencies.end());
}

Marks marks_along(const StripeCurves& curves, float step) {
  Marks marks;
  marks.lines = resampled(curves.lines, step);
  const auto& points = marks.lines.points;
  marks.along.resize(points.size());
  marks.adjacent.resize(points.size());
  for (std::size_t line = 0; line < marks.lines.count(); ++line) {
    const Index first = marks.lines.offsets[line], end = marks.lines.offsets[line + 1];
    const bool closed = marks.lines.closed[line];
    for (Index i = first; i < end; ++i) {
      const Index before = i > first ? i - 1 : closed ? end - 1 : i;
      const Index behind = i + 1 < end ? i + 1 : closed ? first : i;
      marks.adjacent[i] = {before, behind};
      marks.along[i] = (points[behind] - points[before]).stableNormalized();
    }
  }
  return marks;
}

/// The frequency at each point is that of the nearest vertex.
void add_frequencies(const WavePattern& pattern, Marks& marks) {
  const PointTree vertices(pattern.mesh.positions);
  marks.frequencies.resize(marks.lines.points.size());
  const float constant = pattern.waves.frequencies.empty() ? 1 : pattern.waves.frequencies[0];
  const bool same = std::all_of(pattern.waves.frequencies.begin(), pattern.waves.frequencies.end(),
                                [&](float f) { return f == constant; });
  const float diagonal = bounding_box(pattern.mesh).diagonal();
  parallel_for(marks.frequencies.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Index> found;
    for (std::size_t i = begin; i < end; ++i) {
      marks.frequencies[i] = constant;
      for (float radius = diagonal / 256; !same; radius *= 2) {
        vertices.within(marks.lines.points[i], radius, found);
        if (found.empty()) continue;
        marks.frequencies[i] = pattern.waves.frequencies[found[0]];
        break;
      }
    }
  });
}

float distance_to_curve(const Marks& marks, const Vec3& p, Index mark) {
  float least = std::numeric_limits<float>::infinity();
  for (const Index other : marks.adjacent[mark]) {
    least = std::min(least,
                     distance_to_segment(p, marks.lines.points[mark], marks.lines.points[other]));
  }
  return least;
}

/// How much longer than the straight way an arc is that meets the normals at both its ends.
float bending(const Vec3& way, const Vec3& normal, const Vec3& other) {
  const Vec3 along = way.stableNormalized();
  const auto tilt = [&](const Vec3& n, const Vec3& up) {
    return std::atan2(n.dot(along), n.dot(up));
  };
  const Vec3 sum = normal + other;
  const Vec3 up = (sum - sum.dot(along) * along).stableNormalized();
  const float half = 0.5f * std::abs(tilt(normal, up) - tilt(other, up));
  return half < 1e-3f ? 1.0f : half / std::sin(std::min(half, 1.5f));
}

/// The mean and both ends of some numbers.
struct GapRange {
  double sum = 0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0;

  GapRange operator+(const GapRange& other) const {
    return {sum + other.sum, std::min(least, other.least), std::max(most, other.most)};
  }
  void add(double x) { *this = *this + GapRange{x, x, x}; }
};

struct RatioSums {
  Moments ratio;
  double within = 0;
  std::size_t gaps = 0;
  GapRange gap_length = {}, gap_ratio = {};

  RatioSums operator+(const RatioSums& other) const {
    return {ratio + other.ratio, within + other.within, gaps + other.gaps,
            gap_length + other.gap_length, gap_ratio + other.gap_ratio};
  }
  void add(double length, double r) {
    ++gaps;
    gap_length.add(length);
    gap_ratio.add(r);
    if (r > kNeighborReach) return;
    ratio.add(r);
    within += r >= 0.9 && r <= 1.1;
  }
};

CurveGaps gaps_of(const RatioSums& sums) {
  if (sums.gaps == 0) return {};
  const auto count = static_cast<double>(sums.gaps);
  return {sums.gaps,
          sums.gap_length.least,
          sums.gap_length.sum / count,
          sums.gap_length.most,
          sums.gap_ratio.least,
          sums.gap_ratio.sum / count,
          sums.gap_ratio.most};
}

/// Adds the distances to the nearest curves on either side of a mark.
void measure(const Marks& marks, Index i, const std::vector<Index>& near, RatioSums& sums) {
  const Vec3& p = marks.lines.points[i];
  const Vec3& normal = marks.lines.normals[i];
  const Vec3 sideways = normal.cross(marks.along[i]).stableNormalized();
  std::array<float, 2> nearest;
  nearest.fill(std::numeric_limits<float>::infinity());
  for (const Index other : near) {
    const Vec3 way = marks.lines.points[other] - p;
    const float aside = way.dot(sideways);
    const bool beside = std::abs(way.dot(marks.along[i])) < kAslant * way.norm() && other != i;
    const bool alike = std::abs(marks.along[i].dot(marks.along[other])) > 0.5f &&
                       normal.dot(marks.lines.normals[other]) > 0.3f;
    if (!beside || !alike) continue;
    float& best = nearest[aside > 0];
    best = std::min(best, distance_to_curve(marks, p, other) *
                              bending(way, normal, marks.lines.normals[other]));
  }
  for (const float distance : nearest) {
    const double ratio = static_cast<double>(distance) * marks.frequencies[i];
    if (ratio <= kGapReach) sums.add(static_cast<double>(distance), ratio);
  }
}

}  // namespace

CurveSpacing measure_curve_spacing(const WavePattern& pattern, const StripeCurves& curves,
                                   std::size_t most_points) {
  const float step = step_along(pattern);
  auto points = static_cast<double>(curves.lines.count());
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    points += length_of(curves.lines, line) / static_cast<double>(step);
  }
  if (points > static_cast<double>(most_points)) return {};
  Marks marks = marks_along(curves, step);
  add_frequencies(pattern, marks);
  const PointTree tree(marks.lines.points);
  const RatioSums sums =
      parallel_sum<RatioSums>(marks.lines.points.size(), [&](std::size_t begin, std::size_t end) {
        RatioSums part;
        std::vector<Index> near;
        for (std::size_t i = begin; i < end; ++i) {
          tree.within(marks.lines.points[i], kGapReach / marks.frequencies[i], near);
          measure(marks, static_cast<Index>(i), near, part);
        }
        return part;
      });
  CurveSpacing spacing;
  spacing.gaps = gaps_of(sums);
  spacing.measured = static_cast<std::size_t>(sums.ratio.count);
  if (spacing.measured == 0) return spacing;
  spacing.mean = sums.ratio.mean();
  spacing.deviation = sums.ratio.deviation();
  spacing.share_within_10_percent = sums.within / sums.ratio.count;
  return spacing;
}

}  // namespace brindle
