#include "brindle/pattern/fairing/unrolled_curve.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include <Eigen/Geometry>

#include "brindle/geometry/surface_walk.h"

namespace brindle {
namespace {

using Eigen::Vector3d;

/// The lower bound of frequencies, as a share of a curve's mean.
constexpr double kLeastShare = 1e-3;

PlanePoint unit(const PlanePoint& way) {
  const double size = std::abs(way);
  return size > 0 ? way / size : PlanePoint(1);
}

/// The angle from one direction to another around a normal, as a unit number.
PlanePoint turn_between(const Vector3d& from, const Vector3d& to, const Vector3d& normal) {
  return unit({from.dot(to), from.cross(to).dot(normal)});
}

/// Rotates a vector by the smallest rotation from one normal to the other.
Vector3d carried(const Vector3d& way, const Vector3d& from, const Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to) * way;
}

/// An edge that two triangles share, oriented as in the first.
struct SharedEdge {
  Vector3d along;
  bool against;  ///< reversed in the second triangle: both have the same side up
};

std::optional<SharedEdge> shared_edge(const Mesh& mesh, Index first, Index second) {
  const Triangle &a = mesh.triangles[first], &b = mesh.triangles[second];
  for (std::size_t m = 0; m < 3; ++m) {
    const Index from = a[m], to = a[(m + 1) % 3];
    for (std::size_t n = 0; n < 3; ++n) {
      const bool same = b[n] == from && b[(n + 1) % 3] == to;
      const bool against = b[n] == to && b[(n + 1) % 3] == from;
      if (!same && !against) continue;
      return SharedEdge{(mesh.positions[to] - mesh.positions[from]).cast<double>(), against};
    }
  }
  return std::nullopt;
}

Index point_after(const Polylines& lines, Index line, Index point) {
  return point + 1 < lines.offsets[line + 1] ? point + 1 : lines.offsets[line];
}

/// One beyond the last point at which a segment begins.
Index last_start(const Polylines& lines, Index line) {
  return lines.offsets[line + 1] - (lines.closed[line] ? 0 : 1);
}

double periods_between(Index a, Index b, double length, std::span<const float> frequencies) {
  return length * 0.5 * (static_cast<double>(frequencies[a]) + static_cast<double>(frequencies[b]));
}

/// The angle by which a curve turns within the surface between two places, at most pi.
double turn_within(const UnrolledCurve& curve, const Station& a, const Station& b) {
  const auto heading = [&](const Station& station) {
    return curve.in_plane(station.place.segment, station.along);
  };
  return std::abs(std::arg(heading(a) * std::conj(heading(b))));
}

/// A direction at a place, and the normal there.
struct Heading {
  Vector3d along, normal;
};

/// The angle between two headings, also far apart: the first one is rotated with its normal.
double angle_between(const Heading& before, const Heading& after) {
  // Normals of unorientable surfaces may point either way.
  const double sign = before.normal.dot(after.normal) < 0 ? -1 : 1;
  const Vector3d straight =
      Eigen::Quaterniond::FromTwoVectors(sign * before.normal, after.normal) * before.along;
  return std::atan2(straight.cross(after.along).norm(), straight.dot(after.along));
}

}  // namespace

double periods_of(const Polylines& lines, Index line, std::span<const float> frequencies) {
  double periods = 0;
  for (Index i = lines.offsets[line]; i < last_start(lines, line); ++i) {
    const Index next = point_after(lines, line, i);
    const auto length = static_cast<double>((lines.points[next] - lines.points[i]).norm());
    periods += periods_between(i, next, length, frequencies);
  }
  return periods;
}

/// The transition from one segment to the next.
struct UnrolledCurve::Joint {
  PlanePoint turn;
  bool flips;  ///< the upper side of the next triangle is opposite to its winding
};

UnrolledCurve::UnrolledCurve(const Mesh& mesh, const Polylines& lines, Index line,
                             std::span<const float> frequencies)
    : closed_(lines.closed[line]) {
  for (Index i = lines.offsets[line]; i < last_start(lines, line); ++i) {
    segments_.push_back(segment_at(mesh, lines, i));
  }
  unroll(mesh);
  measure(lines, line, frequencies);
}

UnrolledCurve::Segment UnrolledCurve::segment_at(const Mesh& mesh, const Polylines& lines,
                                                 Index point) const {
  Segment segment{lines.places[point], lines.arrivals[point]};
  const Vector3d way =
      position_in(mesh, {segment.from.triangle, segment.to}) - position_in(mesh, segment.from);
  segment.length = way.norm();
  segment.along = way.stableNormalized();
  segment.normal = normal_of(corners_of(mesh, segment.from.triangle)).stableNormalized();
  return segment;
}

/// `before` has its final normal, `after` that of its corners.
UnrolledCurve::Joint UnrolledCurve::joint(const Mesh& mesh, const Segment& before,
                                          const Segment& after) {
  const Index first = before.from.triangle, second = after.from.triangle;
  const Vector3d corners_up = normal_of(corners_of(mesh, first));
  const bool flipped = before.normal.dot(corners_up) < 0;
  if (first == second) {
    return {turn_between(before.along, after.along, before.normal), flipped};
  }
  if (const auto edge = shared_edge(mesh, first, second)) {
    const bool flips = flipped == edge->against;
    const Vector3d up = flips ? Vector3d(-after.normal) : after.normal;
    const PlanePoint leaves = turn_between(edge->along, before.along, before.normal);
    return {unit(turn_between(edge->along, after.along, up) * std::conj(leaves)), flips};
  }
  // Across a vertex.
  const bool flips = before.normal.dot(after.normal) < 0;
  const Vector3d up = flips ? Vector3d(-after.normal) : after.normal;
  const Vector3d along = carried(after.along, up, before.normal);
  return {turn_between(before.along, along, before.normal), flips};
}

void UnrolledCurve::unroll(const Mesh& mesh) {
  if (segments_.empty()) return;
  PlanePoint heading = 1;
  for (std::size_t i = 0; i + 1 < segments_.size(); ++i) {
    const Segment& segment = segments_[i];
    Segment& after = segments_[i + 1];
    const Joint joint = UnrolledCurve::joint(mesh, segment, after);
    if (joint.flips) after.normal = -after.normal;
    if (after.length > 0) {
      heading = unit(heading * joint.turn);
    } else {
      after.along = carried(segment.along, segment.normal, after.normal);
    }
    after.heading = heading;
    after.start = segment.start + segment.length * segment.heading;
  }
  const Segment& last = segments_.back();
  second_.number = 1;
  second_.start = last.start + last.length * last.heading;
  Segment first = segments_.front();
  const Joint joint = UnrolledCurve::joint(mesh, last, first);
  second_.turn = unit(last.heading * joint.turn);
  second_.mirrored = joint.flips;
}

void UnrolledCurve::measure(const Polylines& lines, Index line,
                            std::span<const float> frequencies) {
  periods_.push_back(0);
  const Index begin = lines.offsets[line];
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Index from = begin + static_cast<Index>(i);
    const double more =
        periods_between(from, point_after(lines, line, from), segments_[i].length, frequencies);
    periods_.push_back(periods_.back() + more);
    frequencies_.push_back(static_cast<double>(frequencies[from]));
    length_ += segments_[i].length;
  }
  const Index end = closed_ ? begin : lines.offsets[line + 1] - 1;
  frequencies_.push_back(static_cast<double>(frequencies[end]));
  if (!(length_ > 0)) return;
  const double least = kLeastShare * periods() / length_;
  for (double& frequency : frequencies_) frequency = std::max(frequency, least);
}

Vector3d UnrolledCurve::in_space(std::size_t segment, const PlanePoint& way) const {
  const Segment& on = segments_[segment];
  const PlanePoint local = way * std::conj(on.heading);
  return local.real() * on.along + local.imag() * leftward(segment);
}

PlanePoint UnrolledCurve::in_plane(std::size_t segment, const Vector3d& way) const {
  const Segment& on = segments_[segment];
  return PlanePoint(way.dot(on.along), way.dot(leftward(segment))) * on.heading;
}

UnrolledCurve::Round UnrolledCurve::next(const Round& round) const {
  return {round.number + 1, round.start + round.turned(second_.start), round.turned(second_.turn),
          round.mirrored != second_.mirrored};
}

UnrolledCurve::Round UnrolledCurve::previous(const Round& round) const {
  Round before{round.number - 1, 0, 1, round.mirrored != second_.mirrored};
  before.turn = round.turn * std::conj(before.turned(second_.turn));
  before.start = round.start - before.turned(second_.start);
  return before;
}

UnrolledPlace UnrolledCurve::Walker::at(double periods, double round) {
  while (round < round_.number) round_ = curve_.previous(round_);
  while (round > round_.number) round_ = curve_.next(round_), segment_ = 0;
  const std::vector<double>& passed = curve_.periods_;
  while (segment_ + 1 < curve_.segments_.size() && !(periods < passed[segment_ + 1])) ++segment_;
  const Segment& segment = curve_.segments_[segment_];
  const double size = passed[segment_ + 1] - passed[segment_];
  const double share = size > 0 ? std::clamp((periods - passed[segment_]) / size, 0.0, 1.0) : 0;
  TrianglePoint place = segment.from;
  for (std::size_t m = 0; m < 3; ++m) {
    place.barycentric[m] += share * (segment.to[m] - place.barycentric[m]);
  }
  const PlanePoint point = segment.start + share * segment.length * segment.heading;
  const double frequency =
      (1 - share) * curve_.frequencies_[segment_] + share * curve_.frequencies_[segment_ + 1];
  return {round_.start + round_.turned(point), segment_, place, frequency};
}

std::vector<Station> stations(const Mesh& mesh, const UnrolledCurve& curve, double from,
                              double to) {
  const double all = curve.periods();
  if (curve.closed() && (to - from > all || curve.changes_sides())) return {};
  std::vector<Station> result;
  UnrolledCurve::Walker walker(curve);
  const auto steps = static_cast<int>(std::round((to - from) / kStationStep));
  for (int i = 0; i <= steps; ++i) {
    const double periods = from + i * kStationStep;
    if (!curve.closed() && (periods < 0 || periods > all)) continue;
    const double round = curve.closed() ? std::floor(periods / all) : 0;
    const UnrolledPlace place = walker.at(periods - round * all, round);
    result.push_back({periods, place, position_in(mesh, place.place), curve.along(place.segment),
                      curve.leftward(place.segment)});
  }
  return result;
}

std::vector<Station> back_from_end(const Mesh& mesh, const UnrolledCurve& curve, std::size_t end,
                                   double farthest) {
  const double all = curve.periods();
  const double reach = std::min(farthest, all / 2 - kStationStep);
  if (reach < kStationStep) return {};
  std::vector<Station> back =
      end == 0 ? stations(mesh, curve, 0, reach) : stations(mesh, curve, all - reach, all);
  if (end == 1) std::reverse(back.begin(), back.end());
  return back;
}

bool has_turned(const UnrolledCurve& curve, const std::vector<Station>& own, std::size_t station,
                double most) {
  constexpr std::size_t kStride = 4;
  const auto end = std::min(own.size(), station + kStationsPerPeriod + 1);
  for (std::size_t i = station + kStride; i < end; i += kStride) {
    if (turn_within(curve, own[station], own[i]) > most) return true;
  }
  return false;
}

double turn_at_end(const Mesh& mesh, const std::vector<TrianglePoint>& places, std::size_t end,
                   const std::vector<Station>& own, std::size_t station) {
  const auto normal = [&](const TrianglePoint& at) {
    return normal_of(corners_of(mesh, at.triangle)).stableNormalized();
  };
  const auto heading = [&](std::size_t k) {
    return Heading{position_in(mesh, places[k]) - position_in(mesh, places[k - 1]),
                   normal(places[k])};
  };
  const std::size_t last = places.size() - 1;
  if (last == 0) return 0;
  if (last > kStationsPerPeriod)
    return angle_between(heading(last - kStationsPerPeriod), heading(last));
  const Station& behind = own[std::min(station + kStationsPerPeriod - last, own.size() - 1)];
  const double towards = end == 0 ? -1 : 1;
  return angle_between({towards * behind.along, normal(behind.place.place)}, heading(last));
}

}  // namespace brindle
