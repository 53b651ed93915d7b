#include "brindle/pattern/fairing/smooth_forks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/pattern/stripe_curves.h"

namespace brindle {
namespace {

using Eigen::Vector3d;

constexpr double kOnCurve = 1e-5;  // barycentric
// In periods:
constexpr double kForkStep = 0.05;
constexpr double kFarthestBack = 4;  // that a curve leaves its way before its end
constexpr double kLeastRoom = 0.6, kMostRoom = 1.6;
constexpr double kShortestFork = 1, kLongestFork = 4;
/// The steepest of such a fork runs aside by 25, 32 and 40 degrees; the first that can be is taken.
constexpr double kForksPerRoom[] = {3.2, 2.4, 1.8};
constexpr double kLooksBack[] = {0.75, 1.5, 2.5};
constexpr double kAside = 0.3;         // cosine between a way to the side and the curve
constexpr double kLeastAdvance = 0.4;  // of a step along the other curve
constexpr std::size_t kForksPerReport = 64;
constexpr double kDriftReach = 0.25;  // along which the drift of a curve from another is measured
constexpr double kMostDrift = 0.4;
constexpr double kStraightOn = 0.6;  // cosine
constexpr double kAlongside = 0.94;  // cosine of 20 degrees

/// A place on a curve, and where the curve runs there.
struct Station {
  double periods;
  UnrolledPlace place;
  Vector3d position, along, left;
};

/// Places of a curve at equal steps between two lengths in periods; less where it ends, and nothing
/// of a closed curve that would be passed twice.
std::vector<Station> stations(const Mesh& mesh, const UnrolledCurve& curve, double from,
                              double to) {
  const double all = curve.periods();
  if (curve.closed() && (to - from > all || curve.changes_sides())) return {};
  std::vector<Station> result;
  UnrolledCurve::Walker walker(curve);
  const auto steps = static_cast<int>(std::round((to - from) / kForkStep));
  for (int i = 0; i <= steps; ++i) {
    const double periods = from + i * kForkStep;
    if (!curve.closed() && (periods < 0 || periods > all)) continue;
    const double round = curve.closed() ? std::floor(periods / all) : 0;
    const UnrolledPlace place = walker.at(periods - round * all, round);
    result.push_back({periods, place, position_in(mesh, place.place), curve.along(place.segment),
                      curve.leftward(place.segment)});
  }
  return result;
}

const Station& nearest_of(const std::vector<Station>& stations, const Vector3d& p) {
  return *std::min_element(stations.begin(), stations.end(),
                           [&](const Station& a, const Station& b) {
                             return (a.position - p).squaredNorm() < (b.position - p).squaredNorm();
                           });
}

/// How a curve runs at one of its places beside another curve.
struct Beside {
  double periods;   ///< of the other curve
  double room;      ///< to its left, in periods
  double parallel;  ///< the cosine between both directions, negative where they run against
};

Beside beside(const Station& own, const std::vector<Station>& other) {
  const Station& next = nearest_of(other, own.position);
  const Vector3d way = own.position - next.position;
  const double room = std::copysign(way.norm() * next.place.frequency, way.dot(next.left));
  return {next.periods, room, own.along.dot(next.along)};
}

bool may_leave(const Beside& here, const std::vector<Station>& other) {
  const bool within = here.periods > other.front().periods && here.periods < other.back().periods;
  const double room = std::abs(here.room);
  return within && room >= kLeastRoom && room <= kMostRoom && std::abs(here.parallel) >= kAlongside;
}

/// Whether a curve has turned within the last period before a station, against the other curve. It
/// has come from those behind.
bool comes_from_a_hook(const std::vector<Station>& own, std::size_t station,
                       const std::vector<Station>& other) {
  const double here = beside(own[station], other).parallel;
  constexpr std::size_t kStride = 4;
  const auto end = std::min(own.size(), station + static_cast<std::size_t>(1 / kForkStep) + 1);
  for (std::size_t i = station + kStride; i < end; i += kStride) {
    if (beside(own[i], other).parallel * here < kStraightOn) return true;
  }
  return false;
}

/// From `room` and a drift per period to neither, after `length` periods.
double eased(double room, double drift, double length, double share) {
  const double left = 1 - share;
  return left * left * ((1 + 2 * share) * room + share * length * drift);
}

Index end_point(const Polylines& lines, Index line, std::size_t end) {
  return end == 0 ? lines.offsets[line] : lines.offsets[line + 1] - 1;
}

/// The share of a segment at which it holds a place of its triangle, if it does.
std::optional<double> share_of(const Polylines& lines, Index segment, const TrianglePoint& place) {
  const Vector3d p(place.barycentric.data());
  const Vector3d a(lines.places[segment].barycentric.data());
  const Vector3d along = Vector3d(lines.arrivals[segment].data()) - a;
  const double square = along.squaredNorm();
  if (!(square > 0)) return std::nullopt;
  const double share = std::clamp((p - a).dot(along) / square, 0.0, 1.0);
  if ((p - a - share * along).norm() > kOnCurve) return std::nullopt;
  return share;
}

/// An open line's end, by the triangle that it is in.
struct EndInTriangle {
  Index triangle;
  Index line;
  std::size_t end;
  auto operator<=>(const EndInTriangle&) const = default;
};

constexpr std::size_t kNoSegment = std::numeric_limits<std::size_t>::max();

/// Those that touch, and those in branches and singularities that do not.
std::vector<TouchingEnd> inner_ends(const StripeCurves& curves,
                                    const std::vector<TouchingEnd>& touches) {
  std::vector<TouchingEnd> ends;
  auto next = touches.begin();
  for (Index line = 0; line < curves.lines.count(); ++line) {
    for (const std::size_t end : {0u, 1u}) {
      const CurveEnd kind = curves.ends[line][end];
      if (next != touches.end() && next->line == line && next->end == end) {
        ends.push_back(*next++);
      } else if (kind == CurveEnd::branch || kind == CurveEnd::singularity) {
        ends.push_back({line, end, line, kNoSegment, 0});
      }
    }
  }
  return ends;
}

std::vector<std::array<Index, 2>> segments_of_all(const Polylines& lines) {
  std::vector<std::array<Index, 2>> segments;
  for (Index line = 0; line < lines.count(); ++line) {
    const Index count = lines.offsets[line + 1] - lines.offsets[line];
    for (Index i = 0; i + (lines.closed[line] ? 0 : 1) < count; ++i) segments.push_back({line, i});
  }
  return segments;
}

std::array<Vec3, 2> ends_of_segment(const Polylines& lines, const std::array<Index, 2>& segment) {
  const auto points = lines.points_of(segment[0]);
  return {points[segment[1]], points[(segment[1] + 1) % points.size()]};
}

std::vector<EndInTriangle> ends_by_triangle(const Polylines& lines) {
  std::vector<EndInTriangle> ends;
  for (Index line = 0; line < lines.count(); ++line) {
    for (const std::size_t end : {0u, 1u}) {
      if (lines.closed[line]) continue;
      ends.push_back({lines.places[end_point(lines, line, end)].triangle, line, end});
    }
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

}  // namespace

std::vector<TouchingEnd> touching_ends(const StripeCurves& curves, const Mesh& mesh,
                                       std::span<const float> frequencies) {
  std::vector<TouchingEnd> touches;
  if (curves.ends_at_neighbors == 0) return touches;
  const Polylines& lines = curves.lines;
  const std::vector<EndInTriangle> ends = ends_by_triangle(lines);
  for (Index other = 0; other < lines.count(); ++other) {
    std::optional<UnrolledCurve> unrolled;
    const Index first = lines.offsets[other];
    const Index segments = lines.offsets[other + 1] - first - (lines.closed[other] ? 0 : 1);
    for (Index i = 0; i < segments; ++i) {
      const Index triangle = lines.places[first + i].triangle;
      auto end = std::lower_bound(ends.begin(), ends.end(), EndInTriangle{triangle, 0, 0});
      for (; end != ends.end() && end->triangle == triangle; ++end) {
        const Index at = end_point(lines, end->line, end->end);
        const auto share = share_of(lines, first + i, lines.places[at]);
        if (!share) continue;
        if (!unrolled) unrolled.emplace(mesh, lines, other, frequencies);
        const double periods = unrolled->periods_at(i, *share);
        const double own = end->end == 0 ? periods : unrolled->periods() - periods;
        if (end->line == other && own < kShortestFork) continue;  // itself
        touches.push_back({end->line, end->end, other, i, periods});
      }
    }
  }
  const auto same_end = [](const TouchingEnd& a, const TouchingEnd& b) {
    return a.line == b.line && a.end == b.end;
  };
  std::stable_sort(touches.begin(), touches.end(), [](const TouchingEnd& a, const TouchingEnd& b) {
    return std::pair(a.line, a.end) < std::pair(b.line, b.end);
  });
  touches.erase(std::unique(touches.begin(), touches.end(), same_end), touches.end());
  return touches;
}

/// A way from one curve to another.
struct ForkMaker::Fork {
  UnrolledPlace leaves;               ///< its own curve,
  double from_end;                    ///< so many periods from its end
  double length;                      ///< in periods
  std::vector<TrianglePoint> places;  ///< to the last one, which is on the other curve
  TouchingEnd touch;
};

/// Where a fork may begin.
struct ForkMaker::Course {
  const TouchingEnd& touch;
  const UnrolledCurve& other;
  const Station& leaves;
  double from_end;
  Beside here;
  double way;    ///< along the other curve: 1 or -1
  double drift;  ///< by how much the room grows in a period
};

ForkMaker::ForkMaker(const StripeCurves& curves, const std::vector<TouchingEnd>& touches,
                     const WavePattern& pattern, const SurfaceWays& ways, const Progress& progress)
    : curves_(curves),
      pattern_(pattern),
      ways_(ways),
      frequencies_(frequencies_along(pattern, curves.lines)),
      segments_(segments_of_all(curves.lines)),
      tree_(
          segments_.size(),
          [&](Index number) {
            const auto [a, b] = ends_of_segment(curves.lines, segments_[number]);
            return BoundingBox{a.cwiseMin(b), a.cwiseMax(b)};
          },
          progress.part(0, 0.2)),
      touches_(inner_ends(curves, touches)),
      forks_(touches_.size()) {
  parallel_for(
      touches_.size(), progress.part(0.2, 1),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) forks_[i] = fork(touches_[i]);
      },
      1, kForksPerReport);
  drop_conflicts();
}

ForkMaker::~ForkMaker() = default;

/// The fork by which the other curve leaves its way before it comes to where an end touches it.
std::optional<std::size_t> ForkMaker::left_by(const TouchingEnd& touch) const {
  if (touch.segment == kNoSegment) return std::nullopt;
  const double all = periods_of(curves_.lines, touch.other, frequencies_);
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    if (!forks_[i] || touches_[i].line != touch.other) continue;
    const double own = touches_[i].end == 0 ? touch.periods : all - touch.periods;
    if (own < forks_[i]->from_end + kBeforeFork + kForkStep) return i;
  }
  return std::nullopt;
}

/// Of two forks in conflict the one that is led to what is left goes, or else the other one.
void ForkMaker::drop_conflicts() {
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const auto wrong = left_by(forks_[i] ? forks_[i]->touch : touches_[i]);
      if (!wrong) continue;
      forks_[forks_[i] ? i : *wrong].reset();
      changed = true;
    }
  }
}

std::optional<ForkMaker::Fork> ForkMaker::fork_on(const Course& course, double length) const {
  const UnrolledCurve& other = course.other;
  const double all = other.periods(), last = course.here.periods + course.way * length;
  if (!other.closed() && (last < 0 || last > all)) return std::nullopt;
  Fork fork{course.leaves.place, course.from_end, length, {}, course.touch};
  const auto steps = static_cast<int>(std::ceil(length / kForkStep));
  Vector3d before = course.leaves.position;
  for (int k = 1; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const double at = course.here.periods + course.way * length * share;
    const double round = other.closed() ? std::floor(at / all) : 0;
    UnrolledCurve::Walker walker(other);
    const UnrolledPlace on = walker.at(at - round * all, round);
    const double aside = eased(course.here.room, course.drift, length, share) / on.frequency;
    fork.places.push_back(ways_.straight_on(on.place, aside * other.leftward(on.segment)));
    const Vector3d position = position_in(pattern_.mesh, fork.places.back());
    const double advance = course.way * (position - before).dot(other.along(on.segment));
    // Where the other curve bends round the fork, ways beside it may run back.
    if (advance * on.frequency < kLeastAdvance * length / steps) return std::nullopt;
    before = position;
    fork.touch.segment = on.segment;
    fork.touch.periods = at - round * all;
  }
  return fork;
}

std::optional<ForkMaker::Fork> ForkMaker::fork(const TouchingEnd& touch) const {
  if (touch.segment != kNoSegment) {
    if (auto made = fork_beside(touch)) return made;
  }
  for (const TouchingEnd& neighbor : neighbors_of(touch)) {
    if (auto made = fork_beside(neighbor)) return made;
  }
  return std::nullopt;
}

/// Other places that an end might be led to: on the nearest curves on both sides, not far before
/// it.
std::vector<TouchingEnd> ForkMaker::neighbors_of(const TouchingEnd& touch) const {
  const Polylines& lines = curves_.lines;
  const UnrolledCurve curve(pattern_.mesh, lines, touch.line, frequencies_);
  std::vector<TouchingEnd> found;
  for (const double back : kLooksBack) {
    const double at = touch.end == 0 ? back : curve.periods() - back;
    if (at < 0 || at > curve.periods()) continue;
    const Station here = stations(pattern_.mesh, curve, at, at).front();
    const double reach = kMostRoom / here.place.frequency;
    std::array<double, 2> least = {reach * reach, reach * reach};
    std::array<std::optional<std::array<Index, 2>>, 2> nearest;
    const auto look_at = [&](Index number) {
      const auto [a, b] = ends_of_segment(lines, segments_[number]);
      const Vector3d way = (0.5f * (a + b)).cast<double>() - here.position;
      const Vector3d along = (b - a).cast<double>().stableNormalized();
      const std::size_t side = way.dot(here.left) > 0;
      const bool near_enough = way.squaredNorm() < least[side];
      const bool beside = std::abs(way.dot(here.along)) < kAside * way.norm();
      if (!near_enough || !beside || std::abs(along.dot(here.along)) < kAlongside) return;
      least[side] = way.squaredNorm();
      nearest[side] = segments_[number];
    };
    tree_.visit(
        here.position,
        [&](const BoundingBox&, double square) { return square < std::max(least[0], least[1]); },
        look_at);
    for (const auto& segment : nearest) {
      if (!segment || (*segment)[0] == touch.other || (*segment)[0] == touch.line) continue;
      const UnrolledCurve other(pattern_.mesh, lines, (*segment)[0], frequencies_);
      const double periods = other.periods_at((*segment)[1], 0.5);
      found.push_back({touch.line, touch.end, (*segment)[0], (*segment)[1], periods});
    }
  }
  return found;
}

std::optional<ForkMaker::Fork> ForkMaker::fork_beside(const TouchingEnd& touch) const {
  const Mesh& mesh = pattern_.mesh;
  const UnrolledCurve curve(mesh, curves_.lines, touch.line, frequencies_);
  const UnrolledCurve other(mesh, curves_.lines, touch.other, frequencies_);
  const double reach = std::min(kFarthestBack, curve.periods() / 2 - kForkStep);
  if (reach < kForkStep) return std::nullopt;
  const bool at_start = touch.end == 0;
  std::vector<Station> own = stations(mesh, curve, at_start ? 0 : curve.periods() - reach,
                                      at_start ? reach : curve.periods());
  if (!at_start) std::reverse(own.begin(), own.end());
  const double around = kFarthestBack + kLongestFork;
  const std::vector<Station> beside_it =
      stations(mesh, other, touch.periods - around, touch.periods + around);
  if (beside_it.empty()) return std::nullopt;
  const auto back = static_cast<std::size_t>(kDriftReach / kForkStep);
  for (std::size_t i = 0; i + back < own.size(); ++i) {
    const Beside here = beside(own[i], beside_it), before = beside(own[i + back], beside_it);
    if (!may_leave(here, beside_it) || !may_leave(before, beside_it)) continue;
    if (comes_from_a_hook(own, i, beside_it)) continue;
    // Towards the end of the curve, along the other one.
    const double way = (here.parallel > 0) == at_start ? -1 : 1;
    const double drift =
        std::clamp((here.room - before.room) / kDriftReach, -kMostDrift, kMostDrift);
    const Course course{touch, other, own[i], static_cast<double>(i) * kForkStep, here, way, drift};
    for (const double per_room : kForksPerRoom) {
      const double length = std::clamp(per_room * std::abs(here.room), kShortestFork, kLongestFork);
      if (auto made = fork_on(course, length)) return made;
    }
  }
  return std::nullopt;
}

std::array<double, 2> ForkMaker::forks_of(Index line) const {
  std::array<double, 2> lengths{};
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    if (forks_[i] && touches_[i].line == line) lengths[touches_[i].end] = forks_[i]->length;
  }
  return lengths;
}

std::vector<SurfaceWays::Piece> ForkMaker::forked(Index line) const {
  using Pieces = std::vector<SurfaceWays::Piece>;
  Pieces pieces = pieces_of(curves_.lines, line);
  // From the last end to the first, so that segments keep their numbers.
  for (std::size_t i = touches_.size(); i-- > 0;) {
    if (!forks_[i] || touches_[i].line != line) continue;
    const bool at_start = touches_[i].end == 0;
    const UnrolledPlace& leaves = forks_[i]->leaves;
    const auto cut = pieces.begin() + static_cast<std::ptrdiff_t>(leaves.segment);
    std::vector<TrianglePoint> places = forks_[i]->places;
    places.insert(places.begin(), leaves.place);
    if (at_start) {
      cut->from = leaves.place.barycentric;
      pieces.erase(pieces.begin(), cut);
      std::reverse(places.begin(), places.end());
    } else {
      cut->to = leaves.place.barycentric;
      pieces.erase(cut + 1, pieces.end());
    }
    Pieces way;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      add_way(pattern_, ways_, places[k], places[k + 1], 0, way);
    }
    pieces.insert(at_start ? pieces.begin() : pieces.end(), way.begin(), way.end());
  }
  return pieces;
}

}  // namespace brindle
