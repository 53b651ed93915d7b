#include "brindle/pattern/trimmed_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/box_tree.h"
#include "brindle/geometry/surface_walk.h"
#include "brindle/pattern/curve_spacing.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

constexpr double kCutStep = 0.05;  // between places where an end may be cut, times 1/f
/// A curve is not its own neighbour within this distance along itself, times 1/f.
constexpr double kOwnStretch = 1.5;
/// A curve ahead of an end that runs the same way, each within 45 degrees, continues it.
constexpr float kAhead = 0.7f;
/// An end is also cut back for a hook: where it turns by more than kStraight against the curve one
/// period before it, but by no more than kLongestHook / f.
constexpr float kStraight = 0.9f;                  // cosine
constexpr double kLongestHook = 2 + kCutStep / 2;  // between two steps, so rounding has no effect
constexpr double kDirection = 0.002;  // length over which directions are measured, times 1/f
constexpr float kSameSide = 0.3f;     // cosine between normals on one side of the surface
constexpr std::size_t kCurvesPerReport = 64;

struct LineSegment {
  Index line, from, to;
};

/// A place on a line.
struct LinePlace {
  Index segment_from;  ///< the point before it
  float share;         ///< of the segment to the next point
  Vec3 position, normal;
  float frequency;
};

/// The lengths cut off both ends of a line.
using CutLengths = std::array<double, 2>;

class EndTrimmer {
 public:
  EndTrimmer(const StripeCurves& curves, std::span<const float> frequencies, float least_gap,
             const Progress& progress)
      : curves_(curves),
        lines_(curves.lines),
        frequencies_(frequencies),
        least_gap_(least_gap),
        segments_(segments_of(curves.lines)),
        passed_(lengths_before(curves.lines)),
        tree_(
            segments_.size(), [&](Index number) { return box_of(number); }, progress) {}

  CutLengths cuts(Index line) const {
    CutLengths cuts{};
    for (const std::size_t end : {0u, 1u}) {
      if (is_inner(curves_.ends[line][end])) cuts[end] = cut_at(line, end);
    }
    return cuts;
  }

  /// Whether less than a period is left.
  bool is_speck(Index line, const CutLengths& cuts) const {
    const double left = length(line) - cuts[0] - cuts[1];
    const double middle = std::clamp(cuts[0] + left / 2, 0.0, length(line));
    return left * static_cast<double>(place_at(line, middle).frequency) < 1;
  }

  /// The length of an open line.
  double length(Index line) const { return passed_[lines_.offsets[line + 1] - 1]; }

  /// The place at a length from an open line's first point.
  LinePlace place_at(Index line, double length) const {
    const Index first = lines_.offsets[line], last = lines_.offsets[line + 1] - 1;
    const auto begin = passed_.begin();
    const auto after = std::upper_bound(begin + first, begin + last, length);
    const Index to = std::max(static_cast<Index>(after - begin), first + 1);
    const Index from = to - 1;
    const double size = passed_[to] - passed_[from];
    const double share = size > 0 ? std::clamp((length - passed_[from]) / size, 0.0, 1.0) : 0;
    const auto t = static_cast<float>(share);
    const Vec3 normal = (1 - t) * lines_.normals[from] + t * lines_.normals[to];
    return {from, t, lines_.points[from] + t * (lines_.points[to] - lines_.points[from]),
            normal.stableNormalized(), (1 - t) * frequencies_[from] + t * frequencies_[to]};
  }

 private:
  static bool is_inner(CurveEnd end) {
    return end == CurveEnd::branch || end == CurveEnd::singularity;
  }

  static std::vector<LineSegment> segments_of(const Polylines& lines) {
    std::vector<LineSegment> segments;
    segments.reserve(lines.points.size());
    for (Index line = 0; line < lines.count(); ++line) {
      const Index first = lines.offsets[line], end = lines.offsets[line + 1];
      for (Index i = first; i + 1 < end; ++i) segments.push_back({line, i, i + 1});
      if (lines.closed[line]) segments.push_back({line, end - 1, first});
    }
    return segments;
  }

  static std::vector<double> lengths_before(const Polylines& lines) {
    std::vector<double> passed(lines.points.size());
    for (std::size_t line = 0; line < lines.count(); ++line) {
      for (Index i = lines.offsets[line] + 1; i < lines.offsets[line + 1]; ++i) {
        passed[i] =
            passed[i - 1] + static_cast<double>((lines.points[i] - lines.points[i - 1]).norm());
      }
    }
    return passed;
  }

  BoundingBox box_of(Index number) const {
    const Vec3 &a = lines_.points[segments_[number].from], &b = lines_.points[segments_[number].to];
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }

  /// The length to cut off at an end, which removes crowded parts and hooks; the whole length if
  /// the line is crowded everywhere.
  double cut_at(Index line, std::size_t end) const {
    const double whole = length(line);
    std::optional<double> room;  // the first cut with enough room
    for (double cut = 0; cut < whole;) {
      const LinePlace place = from_end(line, end, cut);
      const double period = 1 / static_cast<double>(place.frequency);
      if (room && cut > *room + kLongestHook * period) break;
      const double at = end == 0 ? cut : whole - cut;
      if (!is_crowded(line, at, place, from_end(line, end, cut + period))) {
        if (!is_turned(line, end, cut, period)) return cut;
        if (!room) room = cut;
      }
      cut += kCutStep * period;
    }
    return room.value_or(whole);
  }

  LinePlace from_end(Index line, std::size_t end, double way) const {
    const double whole = length(line);
    return place_at(line, end == 0 ? std::min(way, whole) : std::max(whole - way, 0.0));
  }

  /// Whether a curve has turned within the surface against its direction one period before.
  /// Directions are measured over kDirection, because single segments may be too short.
  bool is_turned(Index line, std::size_t end, double cut, double period) const {
    const auto towards_end = [&](double way) {
      return Vec3(from_end(line, end, way).position -
                  from_end(line, end, way + kDirection * period).position)
          .stableNormalized();
    };
    const double before = std::min(cut + period, length(line) - kDirection * period);
    // NaN between opposite normals, where the turn is undefined; the comparison is then false.
    const Vec3 bent = transported(towards_end(before), from_end(line, end, before).normal,
                                  from_end(line, end, cut).normal);
    return towards_end(cut).dot(bent) < kStraight;
  }

  /// A place on a line that its neighbours may crowd.
  struct Crowding {
    Index line;
    double at;  ///< its position along the line
    const LinePlace& place;
    Vec3 along;   ///< direction towards the end, over the last period
    float reach;  ///< neighbours that are nearer crowd it
  };

  /// Whether another curve beside a place is nearer than the least gap.
  bool is_crowded(Index line, double at, const LinePlace& place, const LinePlace& before) const {
    const Crowding crowding{line, at, place, (place.position - before.position).stableNormalized(),
                            least_gap_ / place.frequency};
    const auto square_of_reach = static_cast<double>(crowding.reach * crowding.reach);
    bool crowded = false;
    tree_.visit(
        place.position.cast<double>(),
        [&](const BoundingBox&, double square) { return !crowded && square < square_of_reach; },
        [&](Index number) { crowded = crowded || crowds(segments_[number], crowding); });
    return crowded;
  }

  bool crowds(const LineSegment& segment, const Crowding& crowding) const {
    const LinePlace& place = crowding.place;
    const Vec3& a = lines_.points[segment.from];
    const Vec3 side = lines_.points[segment.to] - a;
    const float square = side.squaredNorm();
    const float t =
        square > 0 ? std::clamp((place.position - a).dot(side) / square, 0.0f, 1.0f) : 0.0f;
    if (segment.line == crowding.line) {
      const double way_along =
          passed_[segment.from] + static_cast<double>(t * side.norm()) - crowding.at;
      if (std::abs(way_along) * static_cast<double>(place.frequency) < kOwnStretch) return false;
    }
    const Vec3 way = a + t * side - place.position;
    const Vec3& normal = lines_.normals[t < 0.5f ? segment.from : segment.to];
    if (normal.dot(place.normal) < kSameSide) return false;
    const bool goes_on = std::abs(way.dot(crowding.along)) > kAhead * way.norm() &&
                         std::abs(side.dot(crowding.along)) > kAhead * side.norm();
    if (goes_on) return false;
    return way.norm() * arc_over_chord(way, place.normal, normal) < crowding.reach;
  }

  const StripeCurves& curves_;
  const Polylines& lines_;
  std::span<const float> frequencies_;
  float least_gap_;
  std::vector<LineSegment> segments_;
  std::vector<double> passed_;  // length from the line's first point to each point
  BoxTree tree_;
};

/// Copies lines without the parts that are cut off.
class LineCutter {
 public:
  LineCutter(const StripeCurves& from, const EndTrimmer& trimmer, StripeCurves& to)
      : from_(from), trimmer_(trimmer), to_(to) {
    to_.lines.origin = from.lines.origin;
    to_.joined_ends = from.joined_ends;
    to_.ends_at_neighbors = from.ends_at_neighbors;
  }

  void add(Index line, const CutLengths& cuts) {
    const Polylines& lines = from_.lines;
    Index first = lines.offsets[line], last = lines.offsets[line + 1] - 1;
    if (cuts[0] > 0) first = add_cut(line, cuts[0]).segment_from + 1;
    const bool cut_behind = cuts[1] > 0;
    const LinePlace behind = trimmer_.place_at(line, trimmer_.length(line) - cuts[1]);
    if (cut_behind) last = behind.segment_from;
    to_.lines.add(lines, first, last + 1);
    if (cut_behind) add_last(behind);
    to_.lines.end_line(lines.closed[line]);
    to_.ends.push_back(from_.ends[line]);
  }

 private:
  LinePlace add_cut(Index line, double length) {
    const LinePlace place = trimmer_.place_at(line, length);
    const Polylines& lines = from_.lines;
    to_.lines.add(place.position, place.normal);
    if (!lines.arrivals.empty()) {
      to_.lines.places.push_back(lines.place_on(place.segment_from, place.share));
      to_.lines.arrivals.push_back(lines.arrivals[place.segment_from]);
    }
    return place;
  }

  /// Adds the last point of a cut line and ends the segment before it there.
  void add_last(const LinePlace& place) {
    to_.lines.add(place.position, place.normal);
    if (from_.lines.arrivals.empty()) return;
    const TrianglePoint point = from_.lines.place_on(place.segment_from, place.share);
    to_.lines.arrivals.back() = point.barycentric;
    to_.lines.places.push_back(point);
    to_.lines.arrivals.push_back(point.barycentric);
  }

  const StripeCurves& from_;
  const EndTrimmer& trimmer_;
  StripeCurves& to_;
};

void check_trim(const StripeCurves& curves, std::span<const float> frequencies, float least_gap) {
  if (!(least_gap > 0 && least_gap <= 1)) {
    throw Error("ends of curves: the least gap must be above 0 and at most 1 spacing");
  }
  if (frequencies.size() != curves.lines.points.size()) {
    throw Error("ends of curves: every point needs a frequency");
  }
}

}  // namespace

StripeCurves trimmed_ends(const StripeCurves& curves, std::span<const float> frequencies,
                          float least_gap, const Progress& progress) {
  check_trim(curves, frequencies, least_gap);
  const std::size_t count = curves.lines.count();
  JobStages stages(progress, {{"boxes", 1}, {"ends", 3}});
  const EndTrimmer trimmer(curves, frequencies, least_gap, stages.begin("boxes"));
  std::vector<CutLengths> cuts(count);
  parallel_for(
      count, stages.begin("ends"),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t line = begin; line < end; ++line) {
          if (!curves.lines.closed[line]) cuts[line] = trimmer.cuts(static_cast<Index>(line));
        }
      },
      1, kCurvesPerReport);
  StripeCurves result;
  LineCutter cutter(curves, trimmer, result);
  for (Index line = 0; line < count; ++line) {
    const double cut = cuts[line][0] + cuts[line][1];
    result.trimmed_ends += (cuts[line][0] > 0) + (cuts[line][1] > 0);
    if (cut > 0 && trimmer.is_speck(line, cuts[line])) {
      ++result.trimmed_away;
      continue;
    }
    cutter.add(line, cuts[line]);
  }
  stages.finish();
  return result;
}

namespace {

using Point = Eigen::Vector3d;

constexpr double kRunOnReach = 2;  // periods
constexpr double kBeyond = 1e-9;   // smaller distances, over the triangle's size, count as zero
constexpr int kMostTriangles = 4096;

Point point_of(const PieceEnd& end) {
  return {end.barycentric[0], end.barycentric[1], end.barycentric[2]};
}

/// The distance from `start` along `change` to the piece, if the ray meets it.
std::optional<double> distance_to(const StripePiece& piece, const Point& start,
                                  const Point& change) {
  const Point from = point_of(piece.ends[0]);
  const Point along = point_of(piece.ends[1]) - from;
  const double area = change[1] * along[2] - change[2] * along[1];
  if (area == 0) return {};
  const Point way = from - start;
  const double u = (way[1] * change[2] - way[2] * change[1]) / area;
  if (u < 0 || u > 1) return {};
  return (way[1] * along[2] - way[2] * along[1]) / area;
}

bool lies_on(const Point& p, const StripePiece& piece) {
  const Point from = point_of(piece.ends[0]);
  const Point along = point_of(piece.ends[1]) - from;
  const Point way = p - from;
  const double share = way.dot(along);
  return way.cross(along).norm() <= kBeyond && share >= 0 && share <= along.squaredNorm();
}

}  // namespace

struct EndWalks::Walker : SurfaceWalker {
  double reach = 0;   ///< the largest distance
  double passed = 0;  ///< the distance so far
  bool met = false;   ///< whether it has met a curve
  std::vector<TrianglePoint> way{};

  void go(double distance, const Point& end) {
    passed += distance;
    place = end;
    way.push_back({triangle, {place[0], place[1], place[2]}});
  }
};

/// A step through one triangle.
struct EndWalks::Step {
  double distance;
  Point end;
  int edge;  // crossed at the end; -1 if the step meets a curve
};

EndWalks::EndWalks(const LiftedWaves& waves) : waves_(waves) {}

EndWalks::Step EndWalks::next_step(const Walker& walker) const {
  const std::array<Point, 3> corners = corners_of(waves_.pattern().mesh, walker.triangle);
  const Point change = change_along(corners, walker.direction);
  const WayOut out = way_out(walker, change);
  Step step{out.distance, Point::Zero(), out.edge};
  // The walk starts at the end of a piece, which must not count as met.
  const double least = walker.entered < 0 ? kBeyond * (corners[1] - corners[0]).norm() : 0;
  std::vector<StripePiece> pieces;
  stripe_pieces(waves_.triangle(walker.triangle), true, pieces);
  for (const StripePiece& piece : pieces) {
    const auto distance = distance_to(piece, walker.place, change);
    if (!distance || *distance < least || *distance > step.distance) continue;
    step.distance = *distance;
    step.edge = -1;
  }
  step.end = walker.place + step.distance * change;
  return step;
}

/// Enters the next triangle; false if there is none here, or it has no wave.
bool EndWalks::cross_edge(Walker& walker, int edge) const {
  const MeshEdges& edges = waves_.pattern().edges;
  const Index t = walker.triangle;
  const Index crossed = edges.of_triangle[t][edge];
  const Triangle& triangle = waves_.pattern().mesh.triangles[t];
  std::array<double, 2> between = {walker.place[edge], walker.place[(edge + 1) % 3]};
  if (triangle[edge] > triangle[(edge + 1) % 3]) std::swap(between[0], between[1]);
  const Index next = edges.beyond(t, edge);
  if (next == kNoTriangle) return false;
  enter_triangle(waves_.pattern().mesh, edges, next, crossed, between, walker);
  return waves_.triangle(next).kind != TriangleKind::no_wave;
}

/// Walks until it meets a curve, reaches its limit or cannot continue.
void EndWalks::walk(Walker& walker) const {
  for (int triangles = 0; triangles < kMostTriangles; ++triangles) {
    const Step step = next_step(walker);
    if (!(walker.passed + step.distance <= walker.reach)) return;
    walker.go(step.distance, step.end);
    walker.met = step.edge < 0;
    if (walker.met || !cross_edge(walker, step.edge)) return;
  }
}

std::optional<std::vector<TrianglePoint>> EndWalks::way_on(
    std::size_t t, const StripePiece& piece, std::span<const StripePiece> pieces) const {
  const Point end = point_of(piece.ends[1]);
  const bool met = std::any_of(pieces.begin(), pieces.end(), [&](const StripePiece& other) {
    return &other != &piece && other.ends[1].side != PieceEnd::kInside && lies_on(end, other);
  });
  if (met) return std::vector<TrianglePoint>();

  const Mesh& mesh = waves_.pattern().mesh;
  const std::array<Point, 3> corners = corners_of(mesh, t);
  const Wave& wave = waves_.wave(mesh.triangles[t][0]).wave;
  const Point normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
  const Point across = normal.cross(wave.direction.cast<double>()).stableNormalized();
  const Point aside = across.cross(normal);
  const Point came_along = end - point_of(piece.ends[0]);
  Point came = Point::Zero();
  for (int m = 0; m < 3; ++m) came += came_along[m] * corners[m];
  const Point forward = came.dot(across) < 0 ? Point(-across) : across;
  std::optional<Walker> shorter;
  for (const double side : {1.0, -1.0}) {
    const Point direction = (forward + side * aside).normalized();
    Walker walker{{static_cast<Index>(t), end, direction}};
    walker.reach = kRunOnReach / static_cast<double>(wave.frequency);
    walk(walker);
    if (walker.met && (!shorter || walker.passed <= shorter->passed)) shorter = std::move(walker);
  }
  if (!shorter) return std::nullopt;
  return std::move(shorter->way);
}

}  // namespace brindle
