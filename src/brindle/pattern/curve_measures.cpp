#include "brindle/curve_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/box_tree.h"
#include "brindle/geometry/measures.h"
#include "brindle/nearest.h"
#include "brindle/pattern/curve_spacing.h"
#include "brindle/points/point_tree.h"

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

namespace {

constexpr float kNeighborReach = 1.6f;  // search radius for neighbours, times 1/f
constexpr float kGapReach = 2.5f;       // for gaps: reaches the next curve but one, beside a branch
constexpr std::size_t kMarksPerReport = 4096;
constexpr float kStep = 0.2f;     // between points, times 1/f
constexpr float kAslant = 0.24f;  // largest sine off sideways; points are dense enough for it

/// Points along all curves at which distances to neighbours are measured.
struct Marks {
  Polylines lines;
  std::vector<Vec3> along;                     ///< the curve's direction, one per point
  std::vector<std::array<Index, 2>> adjacent;  ///< previous and next point on the curve
  std::vector<float> frequencies = {};         ///< one per point: chosen
  std::vector<float> wanted = {};              ///< one per point: requested
};

Marks marks_along(const StripeCurves& curves, float step, const Progress& progress) {
  Marks marks;
  marks.lines = resampled(curves.lines, step, progress);
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
std::vector<float> frequencies_at(const PointTree& vertices, std::span<const float> by_vertex,
                                  const Polylines& lines, const Progress& progress) {
  std::vector<float> result(lines.points.size());
  const float constant = by_vertex.empty() ? 1 : by_vertex[0];
  const bool same =
      std::all_of(by_vertex.begin(), by_vertex.end(), [&](float f) { return f == constant; });
  parallel_for(result.size(), progress, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> found;
    for (std::size_t i = begin; i < end; ++i) {
      result[i] = constant;
      if (same) continue;
      vertices.nearest(lines.points[i], 1, found);
      result[i] = by_vertex[found[0]];
    }
  });
  return result;
}

float distance_to_curve(const Marks& marks, const Vec3& p, Index mark) {
  float least = std::numeric_limits<float>::infinity();
  for (const Index other : marks.adjacent[mark]) {
    least = std::min(least,
                     distance_to_segment(p, marks.lines.points[mark], marks.lines.points[other]));
  }
  return least;
}

/// Sum and range of numbers.
struct GapRange {
  double sum = 0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0;

  GapRange operator+(const GapRange& other) const {
    return {sum + other.sum, std::min(least, other.least), std::max(most, other.most)};
  }
  void add(double x) { *this = *this + GapRange{x, x, x}; }
};

/// Ratios of distances to neighbours, and how many are within 10 percent of 1.
struct NearRatios {
  PowerSums ratio;
  double within = 0;

  NearRatios operator+(const NearRatios& other) const {
    return {ratio + other.ratio, within + other.within};
  }
  void add(double r) {
    ratio.add(r);
    within += r >= 0.9 && r <= 1.1;
  }
  double share_within() const { return within / ratio.count; }
};

struct RatioSums {
  NearRatios chosen, wanted;
  std::size_t gaps = 0;
  GapRange gap_length = {}, gap_chosen = {}, gap_wanted = {};

  RatioSums operator+(const RatioSums& other) const {
    return {chosen + other.chosen,
            wanted + other.wanted,
            gaps + other.gaps,
            gap_length + other.gap_length,
            gap_chosen + other.gap_chosen,
            gap_wanted + other.gap_wanted};
  }
  void add(double length, double r_chosen, double r_wanted) {
    ++gaps;
    gap_length.add(length);
    gap_chosen.add(r_chosen);
    gap_wanted.add(r_wanted);
    if (r_chosen > kNeighborReach) return;
    chosen.add(r_chosen);
    wanted.add(r_wanted);
  }
};

CurveGaps gaps_of(const RatioSums& sums) {
  if (sums.gaps == 0) return {};
  const auto count = static_cast<double>(sums.gaps);
  return {sums.gaps,
          sums.gap_length.least,
          sums.gap_length.sum / count,
          sums.gap_length.most,
          sums.gap_wanted.least,
          sums.gap_wanted.sum / count,
          sums.gap_wanted.most,
          sums.gap_chosen.least,
          sums.gap_chosen.sum / count,
          sums.gap_chosen.most};
}

/// Finds the marks beside a mark. A run of consecutive marks shares a bounding box.
class MarkTree {
 public:
  MarkTree(const Marks& marks, const Progress& progress)
      : marks_(marks),
        runs_((marks.lines.points.size() + kRun - 1) / kRun, [&](Index run) { return box_of(run); },
              progress) {
    for (std::size_t i = 0; i < marks.adjacent.size(); ++i) {
      for (const Index other : marks.adjacent[i]) {
        longest_ = std::max(longest_, (marks.lines.points[other] - marks.lines.points[i]).norm());
      }
    }
  }

  /// The distances to the nearest curves on either side of a mark, infinite where there is none.
  std::array<float, 2> nearest(Index i) const {
    Search search(marks_, i, longest_);
    runs_.visit(
        marks_.lines.points[i].cast<double>(),
        [&](const BoundingBox& box, double square) { return search.may_count(box, square); },
        [&](Index run) {
          const std::size_t end = std::min<std::size_t>((run + 1) * kRun, marks_.along.size());
          for (std::size_t mark = run * kRun; mark < end; ++mark) {
            search.take(static_cast<Index>(mark));
          }
        });
    return search.nearest;
  }

 private:
  static constexpr std::size_t kRun = 8;

  struct Search {
    Search(const Marks& all, Index mark, float longest_segment)
        : marks(all),
          i(mark),
          longest(longest_segment),
          p(all.lines.points[mark]),
          along(all.along[mark]),
          normal(all.lines.normals[mark]),
          sideways(normal.cross(along).stableNormalized()),
          reach(kGapReach / all.frequencies[mark]) {
      nearest.fill(std::numeric_limits<float>::infinity());
    }

    /// Whether a box may contain a nearer mark. All bounds allow for rounding, so the result is
    /// that of an exhaustive search.
    bool may_count(const BoundingBox& box, double square) const {
      constexpr double kRoom = 1e-3;
      const double least = std::sqrt(square) * (1 - kRoom);
      if (least > static_cast<double>(reach)) return false;
      // A curve may be nearer than its marks by a segment's length; bending only adds distance.
      const double found = std::max(nearest[0], nearest[1]);
      if (least - static_cast<double>(longest) > found * (1 + kRoom)) return false;
      // Rejects boxes that lie ahead or behind, not beside.
      const Vec3 center = 0.5f * (box.lower + box.upper) - p;
      const Vec3 half = 0.5f * (box.upper - box.lower);
      const float before = std::abs(center.dot(along)) - half.dot(along.cwiseAbs());
      const float farthest = (center.cwiseAbs() + half).norm();
      return before <= (kAslant + static_cast<float>(kRoom)) * farthest;
    }

    void take(Index other) {
      const Vec3& q = marks.lines.points[other];
      const Vec3 way = q - p;
      const Vec3 back = p - q;
      if (!(back.x() * back.x() + back.y() * back.y() + back.z() * back.z() < reach * reach)) {
        return;
      }
      const float aside = way.dot(sideways);
      const bool beside = std::abs(way.dot(along)) < kAslant * way.norm() && other != i;
      const bool alike = std::abs(along.dot(marks.along[other])) > 0.5f &&
                         normal.dot(marks.lines.normals[other]) > 0.3f;
      if (!beside || !alike) return;
      float& best = nearest[aside > 0];
      best = std::min(best, distance_to_curve(marks, p, other) *
                                arc_over_chord(way, normal, marks.lines.normals[other]));
    }

    const Marks& marks;
    const Index i;
    const float longest;
    const Vec3 p, along, normal, sideways;
    const float reach;
    std::array<float, 2> nearest;
  };

  BoundingBox box_of(Index run) const {
    const auto& points = marks_.lines.points;
    BoundingBox box{points[run * kRun], points[run * kRun]};
    for (std::size_t i = run * kRun; i < std::min<std::size_t>((run + 1) * kRun, points.size());
         ++i) {
      box.lower = box.lower.cwiseMin(points[i]);
      box.upper = box.upper.cwiseMax(points[i]);
    }
    return box;
  }

  const Marks& marks_;
  BoxTree runs_;
  float longest_ = 0;
};

/// Adds the distances to the nearest curves on either side of a mark.
void measure(const Marks& marks, const MarkTree& tree, Index i, RatioSums& sums) {
  for (const float distance : tree.nearest(i)) {
    const auto length = static_cast<double>(distance);
    const double ratio = length * marks.frequencies[i];
    if (ratio <= kGapReach) sums.add(length, ratio, length * marks.wanted[i]);
  }
}

CurveSpacing spacing_of(const RatioSums& sums) {
  CurveSpacing spacing;
  spacing.gaps = gaps_of(sums);
  spacing.measured = static_cast<std::size_t>(sums.chosen.ratio.count);
  if (spacing.measured == 0) return spacing;
  spacing.mean = sums.chosen.ratio.mean();
  spacing.deviation = sums.chosen.ratio.deviation();
  spacing.share_within_10_percent = sums.chosen.share_within();
  spacing.mean_wanted = sums.wanted.ratio.mean();
  spacing.deviation_wanted = sums.wanted.ratio.deviation();
  spacing.share_within_10_percent_wanted = sums.wanted.share_within();
  return spacing;
}

bool are_more_than(std::size_t most_points, const StripeCurves& curves, float step) {
  auto points = static_cast<double>(curves.lines.count());
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    points += length_of(curves.lines, line) / static_cast<double>(step);
  }
  return points > static_cast<double>(most_points);
}

}  // namespace

float arc_over_chord(const Vec3& way, const Vec3& normal, const Vec3& other) {
  const Vec3 along = way.stableNormalized();
  const auto tilt = [&](const Vec3& n, const Vec3& up) {
    return elementary::atan2(n.dot(along), n.dot(up));
  };
  const Vec3 sum = normal + other;
  const Vec3 up = (sum - sum.dot(along) * along).stableNormalized();
  const float half = 0.5f * std::abs(tilt(normal, up) - tilt(other, up));
  return half < 1e-3f ? 1.0f : half / elementary::sin(std::min(half, 1.5f));
}

CurveSpacing measure_curve_spacing(const WavePattern& pattern, const StripeCurves& curves,
                                   std::size_t most_points, std::span<const float> wanted,
                                   const Progress& progress) {
  const std::span<const float> chosen = pattern.waves.frequencies;
  const float step = kStep / (chosen.empty() ? kStep : *ranges::max_element(chosen));
  if (are_more_than(most_points, curves, step)) return {};
  JobStages stages(progress, {{"points", 1}, {"frequencies", 1}, {"boxes", 1}, {"gaps", 7}});
  Marks marks = marks_along(curves, step, stages.begin("points"));
  const Progress finding = stages.begin("frequencies");
  const PointTree vertices(pattern.mesh.positions, finding.part(0, 0));
  marks.frequencies = frequencies_at(vertices, chosen, marks.lines, finding.part(0, 0.5));
  marks.wanted = wanted.empty()
                     ? marks.frequencies
                     : frequencies_at(vertices, wanted, marks.lines, finding.part(0.5, 1));
  const MarkTree tree(marks, stages.begin("boxes"));
  const RatioSums sums = parallel_sum<RatioSums>(
      marks.lines.points.size(), stages.begin("gaps"),
      [&](std::size_t begin, std::size_t end) {
        RatioSums part;
        for (std::size_t i = begin; i < end; ++i) measure(marks, tree, static_cast<Index>(i), part);
        return part;
      },
      kParallelGrain, kMarksPerReport);
  stages.finish();
  return spacing_of(sums);
}

}  // namespace brindle
