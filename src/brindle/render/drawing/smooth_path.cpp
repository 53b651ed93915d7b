#include "brindle/render/drawing/smooth_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace brindle {
namespace {

using Eigen::Vector2d;
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
