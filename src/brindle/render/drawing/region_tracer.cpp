#include "brindle/render/drawing/region_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

using Eigen::Vector2d;

constexpr int kPointsPerPixel = 2;  // along a side
constexpr int kHalvings = 11;       // of half a pixel: leaves a quarter of a thousandth
constexpr int kDeepest = 6;         // subdivisions of an outline segment
constexpr int kRowsAtOnce = 64;     // between two progress reports

/// Calls `body(i)` for all of [0, count) in parallel.
template <class Body>
void for_parts(std::size_t count, std::size_t part, std::size_t grain, const Progress& progress,
               const Body& body) {
  const auto of_range = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  };
  parallel_for(count, progress, of_range, grain, part);
}

/// Samples a picture at every half pixel, so that wider regions are never missed, and locates the
/// outlines by bisection.
class RegionTracer {
 public:
  RegionTracer(int width, int height, const CodeAt& code_at, const Progress& progress)
      : columns_(kPointsPerPixel * width + 2),
        rows_(kPointsPerPixel * height + 2),
        code_at_(code_at) {
    codes_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for_parts(static_cast<std::size_t>(rows_), kRowsAtOnce, 1, progress, [&](std::size_t row) {
      for (int column = 0; column < columns_; ++column) {
        const std::size_t point = point_number(column, static_cast<int>(row));
        const Vector2d place = place_of(point);
        codes_[point] = code_at_(place.x(), place.y());
      }
    });
  }

  std::vector<OutlineLoop> outlines(const CodeRange& region, double tolerance,
                                    const Progress& progress) const {
    constexpr std::size_t kAtOnce = 1 << 14, kGrain = 256;
    const std::vector<Passage> passages = passages_of(region, progress.part(0, 0.2));
    std::vector<std::size_t> next(passages.size());
    OutlineLoop places(passages.size());
    for_parts(passages.size(), kAtOnce, kGrain, progress.part(0.2, 0.6), [&](std::size_t i) {
      const auto found =
          std::lower_bound(passages.begin(), passages.end(), passages[i].next,
                           [](const Passage& p, std::size_t edge) { return p.edge < edge; });
      next[i] = static_cast<std::size_t>(found - passages.begin());
      places[i] = crossing(region, passages[i].edge);
    });
    std::vector<OutlineLoop> between(passages.size());
    for_parts(passages.size(), kAtOnce, kGrain, progress.part(0.6, 1), [&](std::size_t i) {
      refine(region, places[i], places[next[i]], tolerance, 0, between[i]);
    });
    std::vector<OutlineLoop> loops;
    std::vector<char> passed(passages.size(), 0);
    for (std::size_t start = 0; start < passages.size(); ++start) {
      if (passed[start] != 0) continue;
      OutlineLoop loop;
      for (std::size_t i = start; passed[i] == 0; i = next[i]) {
        passed[i] = 1;
        loop.push_back(places[i]);
        loop.insert(loop.end(), between[i].begin(), between[i].end());
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

 private:
  /// A line enters a cell across `edge` and leaves it across `next`. Edge 2 p runs from grid point
  /// p to the right, edge 2 p + 1 downwards.
  struct Passage {
    std::size_t edge, next;
  };

  std::size_t point_number(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  /// The outermost points lie a quarter of a pixel outside the picture.
  Vector2d place_of(std::size_t point) const {
    const auto columns = static_cast<std::size_t>(columns_);
    return {(static_cast<double>(point % columns) - 0.5) / kPointsPerPixel,
            (static_cast<double>(point / columns) - 0.5) / kPointsPerPixel};
  }

  bool covered(const CodeRange& region, const Vector2d& place) const {
    return region.has(code_at_(place.x(), place.y()));
  }
  void add_passages(const CodeRange& region, int column, int row,
                    std::vector<Passage>& passages) const {
    const std::size_t corner = point_number(column, row);
    const std::size_t below = point_number(column, row + 1);
    // Corners and the edges after them, around the cell.
    const std::array<bool, 4> in{region.has(codes_[corner]), region.has(codes_[corner + 1]),
                                 region.has(codes_[below + 1]), region.has(codes_[below])};
    if (in[0] == in[1] && in[1] == in[2] && in[2] == in[3]) return;
    const std::array<std::size_t, 4> edges{2 * corner, 2 * (corner + 1) + 1, 2 * below,
                                           2 * corner + 1};
    const bool saddle = in[0] == in[2] && in[1] == in[3];
    const bool middle =
        saddle && covered(region, place_of(corner) + Vector2d::Constant(0.5 / kPointsPerPixel));
    // A line enters where the corners change from outside to inside, and leaves where they change
    // back; if the cell's middle is inside, it passes through the middle.
    for (std::size_t k = 0; k < 4; ++k) {
      if (in[k] || !in[(k + 1) % 4]) continue;
      std::size_t leave = (k + 3) % 4;
      if (!middle) {
        for (leave = (k + 1) % 4; !(in[leave] && !in[(leave + 1) % 4]);) leave = (leave + 1) % 4;
      }
      passages.push_back({edges[k], edges[leave]});
    }
  }

  std::vector<Passage> passages_of(const CodeRange& region, const Progress& progress) const {
    std::vector<std::vector<Passage>> of_row(static_cast<std::size_t>(rows_ - 1));
    for_parts(of_row.size(), 8 * kRowsAtOnce, 8, progress, [&](std::size_t row) {
      for (int column = 0; column + 1 < columns_; ++column) {
        add_passages(region, column, static_cast<int>(row), of_row[row]);
      }
    });
    std::vector<Passage> passages;
    for (std::vector<Passage>& row : of_row) {
      passages.insert(passages.end(), row.begin(), row.end());
      row = {};
    }
    std::sort(passages.begin(), passages.end(),
              [](const Passage& a, const Passage& b) { return a.edge < b.edge; });
    return passages;
  }

  Vector2d crossing(const CodeRange& region, std::size_t edge) const {
    const std::size_t from = edge / 2;
    const std::size_t to = from + (edge % 2 == 1 ? static_cast<std::size_t>(columns_) : 1);
    const bool begins_in = region.has(codes_[from]);
    return begins_in ? change_between(region, place_of(from), place_of(to))
                     : change_between(region, place_of(to), place_of(from));
  }

  Vector2d change_between(const CodeRange& region, Vector2d in, Vector2d out) const {
    for (int i = 0; i < kHalvings; ++i) {
      const Vector2d middle = 0.5 * (in + out);
      (covered(region, middle) ? in : out) = middle;
    }
    return 0.5 * (in + out);
  }

  /// Adds points between two others where the outline leaves the straight line. The search goes to
  /// both sides of the midpoint, up to a right angle.
  void refine(const CodeRange& region, const Vector2d& from, const Vector2d& to, double tolerance,
              int depth, OutlineLoop& loop) const {
    constexpr int kSteps = 8;
    const Vector2d way = to - from;
    const double length = way.norm();
    if (depth == kDeepest || length < 2 * tolerance) return;
    const Vector2d middle = 0.5 * (from + to);
    const Vector2d inwards = Vector2d(way.y(), -way.x()) / length;
    const bool inner = covered(region, middle + tolerance * inwards);
    const bool outer = covered(region, middle - tolerance * inwards);
    // Both or neither inside: another outline is as near.
    if (inner != outer) return;
    const Vector2d beyond = inner ? Vector2d(-inwards) : inwards;  // towards the outline
    Vector2d last = middle + tolerance * beyond;
    for (int k = 1; k <= kSteps; ++k) {
      const Vector2d next = middle + (tolerance + 0.6 * length * k / kSteps) * beyond;
      if (covered(region, next) == inner) {
        last = next;
        continue;
      }
      const Vector2d point =
          inner ? change_between(region, last, next) : change_between(region, next, last);
      refine(region, from, point, tolerance, depth + 1, loop);
      loop.push_back(point);
      refine(region, point, to, tolerance, depth + 1, loop);
      return;
    }
  }

  int columns_, rows_;
  const CodeAt& code_at_;
  std::vector<std::uint16_t> codes_;
};

// Smooth curves through points.

using Bezier = std::array<Vector2d, 4>;

constexpr double kReach = 0.35;      // pixels to either side that define the tangent
constexpr double kCornerDeg = 35;    // larger turns within twice the reach are corners
constexpr double kSamePoint = 1e-6;  // pixels
constexpr int kImprovements = 4;     // of the parameters of points along a segment

double turn_between(const Vector2d& a, const Vector2d& b) {
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

Vector2d bezier_point(const Bezier& b, double t) {
  const double s = 1 - t;
  return s * s * s * b[0] + 3 * s * s * t * b[1] + 3 * s * t * t * b[2] + t * t * t * b[3];
}

/// Points of a closed path; the first one is repeated at the end.
class PathFitter {
 public:
  PathFitter(std::vector<Vector2d> points, double tolerance)
      : points_(std::move(points)), tolerance_(tolerance) {}

  Stroke fit() {
    start_at_corner();
    path_ = {points_.front().cast<float>()};
    std::size_t begin = 0;
    const std::size_t last = points_.size() - 1;
    for (std::size_t i = 1; i <= last; ++i) {
      if (i < last && !corner_[i]) continue;
      const bool smooth = !corner_[0] && i == last && begin == 0;
      const Vector2d first_way = smooth ? way_through(0) : way_from(begin, i);
      const Vector2d last_way = smooth ? Vector2d(-first_way) : way_to(begin, i);
      fit_piece(begin, i, first_way, last_way);
      begin = i;
    }
    return std::move(path_);
  }

 private:
  /// The point before or after `i` on the path, at least the reach away.
  Vector2d neighbour(std::size_t i, bool after) const {
    const std::size_t count = points_.size() - 1;
    std::size_t j = i % count;
    for (std::size_t step = 0; step + 1 < count; ++step) {
      j = after ? (j + 1) % count : (j + count - 1) % count;
      if ((points_[j] - points_[i % count]).norm() >= kReach) break;
    }
    return points_[j];
  }
  Vector2d way_through(std::size_t i) const {
    const Vector2d way = neighbour(i, true) - neighbour(i, false);
    return way.norm() > kSamePoint ? Vector2d(way.normalized())
                                   : Vector2d((neighbour(i, true) - points_[i]).normalized());
  }
  /// The tangent after the corner `begin` or, reversed, before the corner `end`.
  Vector2d way_from(std::size_t begin, std::size_t end) const {
    std::size_t j = begin + 1;
    while (j < end && (points_[j] - points_[begin]).norm() < kReach) ++j;
    return (points_[j] - points_[begin]).normalized();
  }
  Vector2d way_to(std::size_t begin, std::size_t end) const {
    std::size_t j = end - 1;
    while (j > begin && (points_[j] - points_[end]).norm() < kReach) --j;
    return (points_[j] - points_[end]).normalized();
  }

  /// Marks corners, only the sharpest of adjacent ones, and rotates the path to start at one.
  void start_at_corner() {
    const std::size_t count = points_.size() - 1;
    std::vector<double> turns(count);
    for (std::size_t i = 0; i < count; ++i) {
      turns[i] =
          std::abs(turn_between(points_[i] - neighbour(i, false), neighbour(i, true) - points_[i]));
    }
    corner_.assign(count + 1, false);
    for (std::size_t i = 0; i < count; ++i) {
      if (turns[i] < kCornerDeg * std::numbers::pi / 180) continue;
      corner_[i] = is_sharpest(turns, i);
    }
    const auto first = std::find(corner_.begin(), corner_.end() - 1, true) - corner_.begin();
    if (first == static_cast<std::ptrdiff_t>(count)) return;
    points_.pop_back();
    corner_.pop_back();
    std::rotate(points_.begin(), points_.begin() + first, points_.end());
    std::rotate(corner_.begin(), corner_.begin() + first, corner_.end());
    points_.push_back(points_.front());
    corner_.push_back(true);
  }
  bool is_sharpest(const std::vector<double>& turns, std::size_t i) const {
    const std::size_t count = turns.size();
    for (const bool after : {false, true}) {
      std::size_t j = i;
      for (std::size_t step = 0; step + 1 < count; ++step) {
        j = after ? (j + 1) % count : (j + count - 1) % count;
        if ((points_[j] - points_[i]).norm() >= kReach) break;
        if (turns[j] > turns[i] || (turns[j] == turns[i] && j < i)) return false;
      }
    }
    return true;
  }

  void add(const Bezier& b) {
    for (std::size_t k = 1; k < 4; ++k) path_.push_back(b[k].cast<float>());
  }

  /// The segment with these ends and tangents whose points at `places` are nearest to the given
  /// ones.
  Bezier nearest_piece(std::size_t begin, std::size_t end, const std::vector<double>& places,
                       const Vector2d& first_way, const Vector2d& last_way) const {
    const Vector2d& a = points_[begin];
    const Vector2d& d = points_[end];
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
    Vector2d right = Vector2d::Zero();
    for (std::size_t i = begin; i <= end; ++i) {
      const double t = places[i - begin], s = 1 - t;
      const Vector2d first = 3 * s * s * t * first_way, last = 3 * s * t * t * last_way;
      const Vector2d rest =
          points_[i] - (s * s * s + 3 * s * s * t) * a - (3 * s * t * t + t * t * t) * d;
      matrix(0, 0) += first.dot(first);
      matrix(0, 1) += first.dot(last);
      matrix(1, 1) += last.dot(last);
      right += Vector2d(first.dot(rest), last.dot(rest));
    }
    matrix(1, 0) = matrix(0, 1);
    const double length = (d - a).norm(), determinant = matrix.determinant();
    Vector2d reach = Vector2d::Constant(length / 3);
    if (std::abs(determinant) > 1e-12 * matrix(0, 0) * matrix(1, 1)) {
      const Vector2d solved = matrix.inverse() * right;
      // Longer handles make loops.
      const double most = 3 * std::max(length, way_length(begin, end));
      if (solved.minCoeff() > 1e-3 * length && solved.maxCoeff() < most) reach = solved;
    }
    return {a, a + reach[0] * first_way, d + reach[1] * last_way, d};
  }
  double way_length(std::size_t begin, std::size_t end) const {
    double length = 0;
    for (std::size_t i = begin; i < end; ++i) length += (points_[i + 1] - points_[i]).norm();
    return length;
  }

  /// Moves parameters to the nearest points of the segment by Newton's method.
  void improve(const Bezier& b, std::size_t begin, std::vector<double>& places) const {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double t = places[i], s = 1 - t;
      const Vector2d off = bezier_point(b, t) - points_[begin + i];
      const Vector2d first =
          3 * (s * s * (b[1] - b[0]) + 2 * s * t * (b[2] - b[1]) + t * t * (b[3] - b[2]));
      const Vector2d second = 6 * (s * (b[2] - 2 * b[1] + b[0]) + t * (b[3] - 2 * b[2] + b[1]));
      const double slope = first.squaredNorm() + off.dot(second);
      if (std::abs(slope) > 1e-12) places[i] = std::clamp(t - off.dot(first) / slope, 0.0, 1.0);
    }
  }

  /// The point with the largest error, and the error.
  std::pair<std::size_t, double> worst(const Bezier& b, std::size_t begin,
                                       const std::vector<double>& places) const {
    std::pair<std::size_t, double> result{begin + places.size() / 2, 0};
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
      const double off = (bezier_point(b, places[i]) - points_[begin + i]).norm();
      if (off > result.second) result = {begin + i, off};
    }
    return result;
  }

  /// Whether all points lie on the line between the ends; tangents of a smooth path may differ by
  /// as much as the tolerance allows.
  bool is_straight(std::size_t begin, std::size_t end) const {
    const Vector2d way = points_[end] - points_[begin];
    const double length = way.norm();
    if (length < kSamePoint) return false;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const Vector2d off = points_[i] - points_[begin];
      const double along = off.dot(way) / length;
      const double beside = std::abs(off.x() * way.y() - off.y() * way.x()) / length;
      if (beside > 0.2 * tolerance_ || along < 0 || along > length) return false;
    }
    return true;
  }

  void fit_piece(std::size_t begin, std::size_t end, const Vector2d& first_way,
                 const Vector2d& last_way) {
    const Vector2d& a = points_[begin];
    const Vector2d& d = points_[end];
    if (end == begin + 1 || is_straight(begin, end)) {
      return add({a, a + (d - a) / 3, d - (d - a) / 3, d});
    }
    std::vector<double> places{0};
    for (std::size_t i = begin; i < end; ++i) {
      places.push_back(places.back() + (points_[i + 1] - points_[i]).norm());
    }
    for (double& place : places) place /= std::max(places.back(), kSamePoint);
    places.back() = 1;
    std::pair<std::size_t, double> off;
    for (int i = 0; i <= kImprovements; ++i) {
      const Bezier piece = nearest_piece(begin, end, places, first_way, last_way);
      off = worst(piece, begin, places);
      if (off.second <= tolerance_) return add(piece);
      if (off.second > 20 * tolerance_) break;
      improve(piece, begin, places);
    }
    const std::size_t middle = std::clamp(off.first, begin + 1, end - 1);
    const Vector2d way = way_through(middle);
    fit_piece(begin, middle, first_way, -way);
    fit_piece(middle, end, way, last_way);
  }

  std::vector<Vector2d> points_;
  std::vector<bool> corner_;
  double tolerance_;
  Stroke path_;
};

}  // namespace

std::vector<std::vector<OutlineLoop>> region_outlines(int width, int height, const CodeAt& code_at,
                                                      std::span<const CodeRange> regions,
                                                      double tolerance, const Progress& progress) {
  constexpr double kSampled = 0.5;
  const RegionTracer tracer(width, height, code_at, progress.part(0, kSampled));
  std::vector<std::vector<OutlineLoop>> outlines;
  const double share = (1 - kSampled) / static_cast<double>(regions.size());
  for (const CodeRange& region : regions) {
    const double begin = kSampled + share * static_cast<double>(outlines.size());
    outlines.push_back(tracer.outlines(region, tolerance, progress.part(begin, begin + share)));
  }
  return outlines;
}

Stroke smooth_closed_path(std::span<const Vector2d> points, double tolerance) {
  std::vector<Vector2d> distinct;
  for (const Vector2d& point : points) {
    if (distinct.empty() || (point - distinct.back()).norm() > kSamePoint) {
      distinct.push_back(point);
    }
  }
  while (distinct.size() > 1 && (distinct.back() - distinct.front()).norm() <= kSamePoint) {
    distinct.pop_back();
  }
  if (distinct.size() < 3) return {};
  distinct.push_back(distinct.front());
  return PathFitter(std::move(distinct), tolerance).fit();
}

}  // namespace brindle
