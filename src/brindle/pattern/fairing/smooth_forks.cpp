#include "brindle/pattern/fairing/smooth_forks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/pattern/fairing/unrolled_curve.h"
#include "brindle/pattern/stripe_curves.h"

namespace brindle {
namespace {

using Eigen::Vector3d;

constexpr double kOnCurve = 1e-5;  // barycentric
// In periods:
constexpr double kFarthestBack = 4;  // farthest from its end that a curve is redirected
constexpr double kLeastRoom = 0.6, kMostRoom = 1.6;
constexpr double kShortestFork = 1, kLongestFork = 4;
/// Fork lengths over the distance of the curves, with steepest angles of 25, 32 and 40 degrees; the
/// first that is possible is taken.
constexpr double kForksPerRoom[] = {3.2, 2.4, 1.8};
constexpr double kLooksBack[] = {0.75, 1.5, 2.5};
constexpr double kElsewhere = 6;  // least distance of two candidates on one curve
constexpr double kAside = 0.3;    // largest cosine between the curve and the path to a neighbour
constexpr double kLeastAdvance = 0.4;  // along the other curve, over a step
constexpr std::size_t kForksPerReport = 64;
constexpr double kDriftReach = 0.25;  // length over which the drift from another curve is measured
constexpr double kMostDrift = 0.4;
constexpr double kStraightOn = 0.6;  // cosine
constexpr double kAlongside = 0.94;  // cosine of 20 degrees
/// Angles of straight paths to the side, in radians; the first that meets a curve is taken.
constexpr double kTurnsAside[] = {0, 0.25, -0.25, 0.45, -0.45};
constexpr double kLongestStraight = 2;
constexpr double kMostTurn = 0.35;       // 20 degrees, within the period before a straight path
constexpr double kMostTurnAtEnd = 0.52;  // 30 degrees, against one period before

const Station& nearest_of(const std::vector<Station>& stations, const Vector3d& p) {
  return *std::min_element(stations.begin(), stations.end(),
                           [&](const Station& a, const Station& b) {
                             return (a.position - p).squaredNorm() < (b.position - p).squaredNorm();
                           });
}

/// The course of a curve beside another one, at one place.
struct Beside {
  double periods;   ///< along the other curve
  double room;      ///< distance to the left of the other curve, in periods
  double parallel;  ///< cosine between both directions
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

/// Whether a curve has turned against the other one within the period before a station. Stations
/// are ordered backwards along the curve.
bool comes_from_a_hook(const std::vector<Station>& own, std::size_t station,
                       const std::vector<Station>& other) {
  const double here = beside(own[station], other).parallel;
  constexpr std::size_t kStride = 4;
  const auto end = std::min(own.size(), station + kStationsPerPeriod + 1);
  for (std::size_t i = station + kStride; i < end; i += kStride) {
    if (beside(own[i], other).parallel * here < kStraightOn) return true;
  }
  return false;
}

/// Eases the room and its drift per period to zero over `length` periods (cubic Hermite).
double eased(double room, double drift, double length, double share) {
  const double left = 1 - share;
  return left * left * ((1 + 2 * share) * room + share * length * drift);
}

Index end_point(const Polylines& lines, Index line, std::size_t end) {
  return end == 0 ? lines.offsets[line] : lines.offsets[line + 1] - 1;
}

/// The position of a place on a segment of its triangle, as a share; nullopt if it is not on it.
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

/// An end of an open line, by its triangle.
struct EndInTriangle {
  Index triangle;
  Index line;
  std::size_t end;
  auto operator<=>(const EndInTriangle&) const = default;
};

constexpr std::size_t kNoSegment = std::numeric_limits<std::size_t>::max();

/// Returns the ends that touch, and all others in branches and singularities.
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

/// A path from one curve to another.
struct JunctionSmoother::Fork {
  UnrolledPlace leaves;               ///< where it leaves its own curve
  double from_end;                    ///< periods from there to the curve's end
  double length;                      ///< in periods
  std::vector<TrianglePoint> places;  ///< its places; the last one is on the other curve
  TouchingEnd touch;
  std::size_t choice = 0;  ///< the number of candidates rejected for it
  bool late = false;       ///< chosen when all others existed, and consistent with them
  bool smooth = true;      ///< meets the other curve tangentially
};

struct JunctionSmoother::Meeting {
  TouchingEnd touch;
  TrianglePoint place;
  double along;  ///< share of the path
};

/// A possible start of a fork.
struct JunctionSmoother::Course {
  const TouchingEnd& touch;
  const UnrolledCurve& other;
  const Station& leaves;
  double from_end;
  Beside here;
  double way;    ///< along the other curve: 1 or -1
  double drift;  ///< growth of the room per period
};

JunctionSmoother::JunctionSmoother(const StripeCurves& curves,
                                   const std::vector<TouchingEnd>& touches,
                                   const WavePattern& pattern, const SurfaceWays& ways,
                                   const Progress& progress)
    : curves_(curves),
      pattern_(pattern),
      ways_(ways),
      unrolled_(curves.lines.count()),
      segments_(curves.lines, progress.part(0, 0.2)),
      touches_(inner_ends(curves, touches)),
      forks_(touches_.size()) {
  const std::vector<float> frequencies = frequencies_along(pattern, curves.lines);
  parallel_for(
      unrolled_.size(), progress.part(0.2, 0.4),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          unrolled_[i].emplace(pattern.mesh, curves.lines, static_cast<Index>(i), frequencies);
        }
      },
      1, kForksPerReport);
  parallel_for(
      touches_.size(), progress.part(0.4, 1),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) forks_[i] = fork(touches_[i], 0);
      },
      1, kForksPerReport);
  solve_conflicts();
}

JunctionSmoother::~JunctionSmoother() = default;

/// The range of a line's touches: the first, and one beyond the last.
std::array<std::size_t, 2> JunctionSmoother::touches_of(Index line) const {
  const auto before = [](const TouchingEnd& touch, Index number) { return touch.line < number; };
  const auto first = std::lower_bound(touches_.begin(), touches_.end(), line, before);
  const auto last = std::lower_bound(first, touches_.end(), line + 1, before);
  return {static_cast<std::size_t>(first - touches_.begin()),
          static_cast<std::size_t>(last - touches_.begin())};
}

/// The fork that redirects the other curve before the point where an end touches it.
std::optional<std::size_t> JunctionSmoother::left_by(const TouchingEnd& touch) const {
  if (touch.segment == kNoSegment) return std::nullopt;
  const double all = unrolled(touch.other).periods();
  const auto [first, last] = touches_of(touch.other);
  for (std::size_t i = first; i < last; ++i) {
    if (!forks_[i]) continue;
    const double own = touches_[i].end == 0 ? touch.periods : all - touch.periods;
    if (own < forks_[i]->from_end + kBeforeFork + kStationStep) return i;
  }
  return std::nullopt;
}

/// Resolves conflicts: forks that lead to a part of a curve that another fork removes. Such a fork
/// takes its next candidate or is dropped. The other fork changes instead if it is straight and
/// this one smooth, or if this end has no fork.
void JunctionSmoother::solve_conflicts() {
  all_are_there_ = true;
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const auto wrong = left_by(forks_[i] ? forks_[i]->touch : touches_[i]);
      if (!wrong) continue;
      const bool stays = !forks_[i] || (forks_[i]->smooth && !forks_[*wrong]->smooth);
      const std::size_t other = stays ? *wrong : i;
      // The first time, restarts from the first candidate, because all other forks now exist.
      forks_[other] = fork(touches_[other], forks_[other]->late ? forks_[other]->choice + 1 : 0);
      if (forks_[other]) forks_[other]->late = true;
      changed = true;
    }
  }
}

std::optional<JunctionSmoother::Fork> JunctionSmoother::fork_on(const Course& course,
                                                                double length) const {
  const UnrolledCurve& other = course.other;
  const double all = other.periods(), last = course.here.periods + course.way * length;
  if (!other.closed() && (last < 0 || last > all)) return std::nullopt;
  Fork fork{course.leaves.place, course.from_end, length, {}, course.touch};
  const auto steps = static_cast<int>(std::ceil(length / kStationStep));
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
    // Where the other curve bends around the fork, paths beside it may run back.
    if (advance * on.frequency < kLeastAdvance * length / steps) return std::nullopt;
    before = position;
    fork.touch.segment = on.segment;
    fork.touch.periods = at - round * all;
  }
  if (all_are_there_ && left_by(fork.touch)) return std::nullopt;
  return fork;
}

/// The first possible fork: smooth ones to all neighbours that turn little, then straight ones,
/// then smooth ones that turn more.
std::optional<JunctionSmoother::Fork> JunctionSmoother::fork(const TouchingEnd& touch,
                                                             std::size_t choice) const {
  std::vector<TouchingEnd> neighbors = neighbors_of(touch);
  if (touch.segment != kNoSegment) neighbors.insert(neighbors.begin(), touch);
  const std::size_t smooth = neighbors.size(), straight = smooth + std::size(kTurnsAside);
  for (; choice < straight + smooth; ++choice) {
    std::optional<Fork> made;
    if (choice < smooth) {
      made = fork_beside(neighbors[choice], kMostTurnAtEnd);
    } else if (choice < straight) {
      made = straight_on(touch, kTurnsAside[choice - smooth]);
    } else {
      made = fork_beside(neighbors[choice - straight], std::numbers::pi);
    }
    if (!made) continue;
    made->choice = choice;
    return made;
  }
  return std::nullopt;
}

/// The first curve that a short straight path meets. Excludes its own curve near its start, `own`
/// periods along it.
std::optional<JunctionSmoother::Meeting> JunctionSmoother::meeting(const TouchingEnd& touch,
                                                                   double own, const Vector3d& from,
                                                                   const Vector3d& to,
                                                                   const Vector3d& upward) const {
  std::optional<Meeting> first;
  const double reach = (to - from).squaredNorm();
  const auto look_at = [&](const CurveSegment& segment) {
    const auto found = segments_.crossing(segment, from, to, upward);
    if (!found || (first && first->along <= found->along)) return;
    const UnrolledCurve& other = unrolled(segment.line);
    const double periods = other.periods_at(segment.number, found->share);
    if (segment.line == touch.line && std::abs(periods - own) < kElsewhere) return;
    first = Meeting{
        {touch.line, touch.end, segment.line, segment.number, periods},
        curves_.lines.place_on(curves_.lines.offsets[segment.line] + segment.number, found->share),
        found->along};
  };
  segments_.visit(
      from, [&] { return reach; }, look_at);
  return first;
}

/// A straight path from the last place where the curve has run straight for a period, `aside`
/// radians to its left, to the first curve.
std::optional<JunctionSmoother::Fork> JunctionSmoother::straight_on(const TouchingEnd& touch,
                                                                    double aside) const {
  const Mesh& mesh = pattern_.mesh;
  const UnrolledCurve& curve = unrolled(touch.line);
  const std::vector<Station> own = back_from_end(mesh, curve, touch.end, kFarthestBack);
  std::size_t at = 0;
  while (at < own.size() && has_turned(curve, own, at, kMostTurn)) ++at;
  if (at == own.size()) return std::nullopt;
  const Station& leaves = own[at];
  const double towards = touch.end == 0 ? -1 : 1;
  const Vector3d direction =
      towards * std::cos(aside) * leaves.along + std::sin(aside) * leaves.left;
  Fork fork{leaves.place, static_cast<double>(at) * kStationStep, 0, {}, touch};
  fork.smooth = false;
  Vector3d before = leaves.position;
  for (double length = kStationStep; length <= kLongestStraight; length += kStationStep) {
    const TrianglePoint place =
        ways_.straight_on(leaves.place.place, length / leaves.place.frequency * direction);
    const Vector3d position = position_in(mesh, place);
    const Vector3d upward = normal_of(corners_of(mesh, place.triangle)).stableNormalized();
    const auto met = meeting(touch, leaves.periods, before, position, upward);
    fork.length = length;
    fork.places.push_back(met ? met->place : place);
    if (met) {
      fork.touch = met->touch;
      if (turn_at_end(mesh, fork.places, touch.end, own, at) > kMostTurnAtEnd) return std::nullopt;
      if (all_are_there_ && left_by(fork.touch)) return std::nullopt;
      return fork;
    }
    if ((position - before).squaredNorm() == 0) return std::nullopt;  // at a boundary
    before = position;
  }
  return std::nullopt;
}

/// Other candidates for an end: on the nearest curves on both sides, shortly before the end.
std::vector<TouchingEnd> JunctionSmoother::neighbors_of(const TouchingEnd& touch) const {
  const UnrolledCurve& curve = unrolled(touch.line);
  std::vector<TouchingEnd> found;
  for (const double back : kLooksBack) {
    const double at = touch.end == 0 ? back : curve.periods() - back;
    if (at < 0 || at > curve.periods()) continue;
    const Station here = stations(pattern_.mesh, curve, at, at).front();
    const double reach = kMostRoom / here.place.frequency;
    std::array<double, 2> least = {reach * reach, reach * reach};
    std::array<std::optional<CurveSegment>, 2> nearest;
    const auto look_at = [&](const CurveSegment& segment) {
      const auto [a, b] = segments_.ends_of(segment);
      const Vector3d way = (0.5f * (a + b)).cast<double>() - here.position;
      const Vector3d along = (b - a).cast<double>().stableNormalized();
      const std::size_t side = way.dot(here.left) > 0;
      const bool near_enough = way.squaredNorm() < least[side];
      const bool beside = std::abs(way.dot(here.along)) < kAside * way.norm();
      if (!near_enough || !beside || std::abs(along.dot(here.along)) < kAlongside) return;
      least[side] = way.squaredNorm();
      nearest[side] = segment;
    };
    segments_.visit(
        here.position, [&] { return std::max(least[0], least[1]); }, look_at);
    for (const auto& segment : nearest) {
      if (!segment) continue;
      const UnrolledCurve& other = unrolled(segment->line);
      const double periods = other.periods_at(segment->number, 0.5);
      const TouchingEnd neighbor{touch.line, touch.end, segment->line, segment->number, periods};
      const bool itself = neighbor.other == touch.line && std::abs(periods - at) < kElsewhere;
      const auto same = [&](const TouchingEnd& one) {
        return one.other == neighbor.other && std::abs(one.periods - periods) < kElsewhere;
      };
      if (itself || same(touch) || std::any_of(found.begin(), found.end(), same)) continue;
      found.push_back(neighbor);
    }
  }
  return found;
}

std::optional<JunctionSmoother::Fork> JunctionSmoother::fork_beside(const TouchingEnd& touch,
                                                                    double most_turn) const {
  const Mesh& mesh = pattern_.mesh;
  const UnrolledCurve& curve = unrolled(touch.line);
  const UnrolledCurve& other = unrolled(touch.other);
  const bool at_start = touch.end == 0;
  const std::vector<Station> own = back_from_end(mesh, curve, touch.end, kFarthestBack);
  if (own.empty()) return std::nullopt;
  const double around = kFarthestBack + kLongestFork;
  const std::vector<Station> beside_it =
      stations(mesh, other, touch.periods - around, touch.periods + around);
  if (beside_it.empty()) return std::nullopt;
  const auto back = static_cast<std::size_t>(kDriftReach / kStationStep);
  for (std::size_t i = 0; i + back < own.size(); ++i) {
    const Beside here = beside(own[i], beside_it), before = beside(own[i + back], beside_it);
    if (!may_leave(here, beside_it) || !may_leave(before, beside_it)) continue;
    if (comes_from_a_hook(own, i, beside_it)) continue;
    // The direction along the other curve towards the end of this one.
    const double way = (here.parallel > 0) == at_start ? -1 : 1;
    const double drift =
        std::clamp((here.room - before.room) / kDriftReach, -kMostDrift, kMostDrift);
    const Course course{touch, other, own[i], static_cast<double>(i) * kStationStep,
                        here,  way,   drift};
    for (const double per_room : kForksPerRoom) {
      const double length = std::clamp(per_room * std::abs(here.room), kShortestFork, kLongestFork);
      auto made = fork_on(course, length);
      if (made && turn_at_end(mesh, made->places, touch.end, own, i) <= most_turn) return made;
    }
  }
  return std::nullopt;
}

std::array<double, 2> JunctionSmoother::forks_of(Index line) const {
  std::array<double, 2> lengths{};
  const auto [first, last] = touches_of(line);
  for (std::size_t i = first; i < last; ++i) {
    if (forks_[i]) lengths[touches_[i].end] = forks_[i]->length;
  }
  return lengths;
}

std::size_t JunctionSmoother::smooth_forks_of(Index line) const {
  const auto [first, last] = touches_of(line);
  std::size_t count = 0;
  for (std::size_t i = first; i < last; ++i) count += forks_[i] && forks_[i]->smooth;
  return count;
}

std::vector<SurfaceWays::Piece> JunctionSmoother::forked(Index line) const {
  using Pieces = std::vector<SurfaceWays::Piece>;
  Pieces pieces = pieces_of(curves_.lines, line);
  const auto [first, last] = touches_of(line);
  // From the last end to the first, so that segments keep their numbers.
  for (std::size_t i = last; i-- > first;) {
    if (!forks_[i]) continue;
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
