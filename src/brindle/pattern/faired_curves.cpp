#include "brindle/pattern/faired_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/surface_walk.h"
#include "brindle/pattern/cut_curves.h"
#include "brindle/pattern/unrolled_curve.h"

namespace brindle {
namespace {

using Eigen::Vector3d;
using WayPiece = SurfaceWays::Piece;

constexpr double kSamplesPerScale = 4;
/// How far a closed curve is unrolled beyond its start on both sides, times the scale: what is
/// farther moves nothing there.
constexpr int kBeyondStart = 8;
/// Of a bound that curves shall not come nearer to than needed: so few rounds do.
constexpr double kAlmost = 0.97;
constexpr int kMostRounds = 20;
constexpr double kNoPiece = 1e-4;    // shorter ones are left out, over the distance of samples
constexpr double kSamePoint = 1e-5;  // barycentric
constexpr double kMostFairedPoints = 0xfffffff0;  // numbers of points are Indices
constexpr std::size_t kLinesPerReport = 32;

/// The deviations y of a curve x of samples at equal distances for which the sum of
/// weight |y|^2 + stiffness |second difference of x + y|^2 is least; those of the two ends are
/// given.
class SmoothingSpline {
 public:
  SmoothingSpline(std::span<const PlanePoint> x, double stiffness,
                  const std::array<PlanePoint, 2>& ends)
      : stiffness_(stiffness), y_(x.size()), right_(x.size()), rows_(x.size()) {
    const std::size_t last = x.size() - 1;
    y_.front() = ends[0];
    y_.back() = ends[1];
    std::vector<PlanePoint> bends(x.size());
    for (std::size_t i = 1; i < last; ++i) {
      bends[i] = x[i - 1] + y_[i - 1] - 2.0 * x[i] + x[i + 1] + y_[i + 1];
    }
    for (std::size_t i = 1; i < last; ++i) {
      right_[i] = -stiffness * (bends[i - 1] - 2.0 * bends[i] + bends[i + 1]);
    }
  }

  /// By the factors L D L^T of a matrix with five diagonals.
  const std::vector<PlanePoint>& deviations(std::span<const double> weights) {
    const std::size_t last = y_.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
      const Row before = i > 1 ? rows_[i - 1] : Row{}, earlier = i > 2 ? rows_[i - 2] : Row{};
      Row& row = rows_[i];
      const double squares = 4 + (i > 1) + (i + 1 < last);
      row.diagonal = weights[i] + stiffness_ * squares -
                     before.first * before.first * before.diagonal -
                     earlier.second * earlier.second * earlier.diagonal;
      row.first = (-4 * stiffness_ - before.second * before.diagonal * before.first) / row.diagonal;
      row.second = stiffness_ / row.diagonal;
      row.right = right_[i] - before.first * before.right - earlier.second * earlier.right;
    }
    for (std::size_t i = last; i-- > 1;) {
      y_[i] = rows_[i].right / rows_[i].diagonal;
      if (i + 1 < last) y_[i] -= rows_[i].first * y_[i + 1];
      if (i + 2 < last) y_[i] -= rows_[i].second * y_[i + 2];
    }
    return y_;
  }

 private:
  struct Row {
    double diagonal = 0, first = 0, second = 0;  ///< beyond the diagonal of L
    PlanePoint right = 0;
  };
  double stiffness_;
  std::vector<PlanePoint> y_, right_;
  std::vector<Row> rows_;
};

/// How far samples deviate over how far they may, each by the largest one near it.
std::vector<double> excess(std::span<const PlanePoint> deviations,
                           std::span<const UnrolledPlace> places) {
  std::vector<double> own(places.size()), around(places.size());
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    own[i] = std::abs(deviations[i]) * places[i].frequency / kMostFaired;
  }
  const auto reach = static_cast<std::ptrdiff_t>(kSamplesPerScale);
  const auto count = static_cast<std::ptrdiff_t>(own.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    around[static_cast<std::size_t>(i)] =
        *std::max_element(own.begin() + std::max<std::ptrdiff_t>(0, i - reach),
                          own.begin() + std::min(count, i + reach + 1));
  }
  return around;
}

/// Where samples would go too far, the length of the spline is shorter: what a corner moves by
/// grows with this length, which is the fourth root of a weight.
std::vector<PlanePoint> bounded_deviations(std::span<const UnrolledPlace> places, double stiffness,
                                           const std::array<PlanePoint, 2>& ends) {
  std::vector<PlanePoint> points;
  for (const UnrolledPlace& place : places) points.push_back(place.point);
  SmoothingSpline spline(points, stiffness, ends);
  std::vector<double> weights(places.size(), 1.0);
  std::vector<PlanePoint> deviations = spline.deviations(weights);
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<double> too_far = excess(deviations, places);
    if (*std::max_element(too_far.begin(), too_far.end()) <= 1) return deviations;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (too_far[i] > kAlmost) weights[i] *= std::pow(too_far[i] / kAlmost, 4);
    }
    deviations = spline.deviations(weights);
  }
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const double far = std::abs(deviations[i]) * places[i].frequency / kMostFaired;
    if (far > 1) deviations[i] /= far;
  }
  return deviations;
}

/// A sample of a curve, and where it goes.
struct MovedSample {
  UnrolledPlace place;
  PlanePoint by;  ///< in the unrolled plane
};

/// Samples of a curve; of a closed one without its first at the end.
std::vector<MovedSample> moved_samples(const UnrolledCurve& curve, double scale,
                                       const std::array<PlanePoint, 2>& ends) {
  const double periods = curve.periods();
  const auto least = curve.closed() ? 8.0 : 3.0;
  const double count = std::max(std::ceil(periods * kSamplesPerScale / scale), least);
  const auto steps = static_cast<std::int64_t>(count);
  const double step = periods / count;
  const auto beyond =
      curve.closed() ? static_cast<std::int64_t>(std::ceil(kBeyondStart * scale / step)) : 0;
  std::vector<UnrolledPlace> places;
  UnrolledCurve::Walker walker(curve);
  for (std::int64_t i = -beyond; i <= steps + beyond; ++i) {
    const double round = curve.closed() ? std::floor(static_cast<double>(i) / count) : 0;
    places.push_back(walker.at((static_cast<double>(i) - round * count) * step, round));
  }
  const auto deviations = bounded_deviations(places, std::pow(scale / step, 4), ends);
  std::vector<MovedSample> samples;
  const auto first = static_cast<std::size_t>(beyond);
  const std::size_t kept = static_cast<std::size_t>(steps) + (curve.closed() ? 0 : 1);
  for (std::size_t i = first; i < first + kept; ++i) samples.push_back({places[i], deviations[i]});
  return samples;
}

/// An end that lies on another curve.
struct Touch {
  Index line;
  std::size_t end;
  Index other;
  std::size_t segment;  ///< of the other one
  double share;
};

struct FairedLine {
  Polylines lines;
  double most = 0;  ///< that a point moved, times f
};

class Fairer {
 public:
  Fairer(const StripeCurves& curves, const WavePattern& pattern, std::span<const float> frequencies,
         double scale)
      : curves_(curves),
        pattern_(pattern),
        frequencies_(frequencies),
        scale_(scale),
        ways_(pattern.mesh, pattern.edges) {
    find_touches();
  }

  FairedLine faired(Index line) const {
    FairedLine result;
    const UnrolledCurve curve(pattern_.mesh, curves_.lines, line, frequencies_);
    if (!(curve.periods() > 0)) {
      add_as_it_is(line, result.lines);
      return result;
    }
    const std::vector<MovedSample> samples = moved_samples(curve, scale_, ends_of(line, curve));
    std::vector<TrianglePoint> places;
    for (const MovedSample& sample : samples) {
      places.push_back(
          ways_.straight_on(sample.place.place, curve.in_space(sample.place.segment, sample.by)));
      result.most = std::max(result.most, std::abs(sample.by) * sample.place.frequency);
    }
    add_line(places, curve.closed(), curve.length() / static_cast<double>(samples.size()),
             result.lines);
    return result;
  }

  /// Points that all curves will have, about.
  double point_count() const {
    double points = static_cast<double>(curves_.lines.points.size());
    for (Index line = 0; line < curves_.lines.count(); ++line) {
      points += periods_of(curves_.lines, line, frequencies_) * kSamplesPerScale / scale_;
    }
    return points;
  }

 private:
  const Polylines& lines() const { return curves_.lines; }

  /// What an end goes along with.
  std::array<PlanePoint, 2> ends_of(Index line, const UnrolledCurve& curve) const {
    std::array<PlanePoint, 2> ends{};
    for (const Touch& touch : touches_) {
      if (touch.line != line) continue;
      const UnrolledCurve other(pattern_.mesh, lines(), touch.other, frequencies_);
      if (!(other.periods() > 0)) continue;
      const std::vector<MovedSample> samples = moved_samples(other, scale_, {});
      const double at = other.periods_at(touch.segment, touch.share);
      const Vector3d way = other.in_space(touch.segment, movement_at(other, samples, at));
      ends[touch.end] = curve.in_plane(touch.end == 0 ? 0 : curve.segment_count() - 1, way);
    }
    return ends;
  }

  /// In the plane, between two samples of a curve.
  static PlanePoint movement_at(const UnrolledCurve& curve, const std::vector<MovedSample>& samples,
                                double periods) {
    const auto steps = static_cast<double>(samples.size() - (curve.closed() ? 0 : 1));
    const double at = std::clamp(periods / curve.periods() * steps, 0.0, steps);
    const auto before = std::min(static_cast<std::size_t>(at), samples.size() - 1);
    const std::size_t after = std::min(before + 1, samples.size() - 1);
    const double share = at - static_cast<double>(before);
    return (1 - share) * samples[before].by + share * samples[after].by;
  }

  /// Where ends lie on other curves.
  void find_touches() {
    if (curves_.ends_at_neighbors == 0) return;
    std::vector<std::pair<Index, Index>> ends;  // triangle, twice the line and the end
    for (Index line = 0; line < lines().count(); ++line) {
      for (const Index end : {0u, 1u}) {
        if (lines().closed[line]) continue;
        const Index point = end == 0 ? lines().offsets[line] : lines().offsets[line + 1] - 1;
        ends.emplace_back(lines().places[point].triangle, 2 * line + end);
      }
    }
    std::sort(ends.begin(), ends.end());
    for (Index line = 0; line < lines().count(); ++line) {
      const Index first = lines().offsets[line];
      for (Index i = first; i < lines().offsets[line + 1]; ++i) {
        const Index triangle = lines().places[i].triangle;
        auto end = std::lower_bound(ends.begin(), ends.end(), std::pair(triangle, Index{0}));
        for (; end != ends.end() && end->first == triangle; ++end) {
          add_touch(end->second, line, i - first);
        }
      }
    }
  }

  void add_touch(Index end, Index other, Index segment) {
    const Index line = end / 2;
    if (line == other) return;
    const bool known = std::any_of(touches_.begin(), touches_.end(), [&](const Touch& touch) {
      return touch.line == line && touch.end == end % 2;
    });
    if (known) return;
    const Index point = end % 2 == 0 ? lines().offsets[line] : lines().offsets[line + 1] - 1;
    const Index from = lines().offsets[other] + segment;
    const Vector3d p(lines().places[point].barycentric.data());
    const Vector3d a(lines().places[from].barycentric.data());
    const Vector3d along = Vector3d(lines().arrivals[from].data()) - a;
    const double square = along.squaredNorm();
    if (!(square > 0)) return;
    const double share = std::clamp((p - a).dot(along) / square, 0.0, 1.0);
    if ((p - a - share * along).norm() > kSamePoint) return;
    touches_.push_back({line, end % 2, other, segment, share});
  }

  void add_as_it_is(Index line, Polylines& to) const {
    const Index begin = lines().offsets[line], end = lines().offsets[line + 1];
    for (Index i = begin; i < end; ++i) {
      to.points.push_back(lines().points[i]);
      to.normals.push_back(lines().normals[i]);
      to.places.push_back(lines().places[i]);
      to.arrivals.push_back(lines().arrivals[i]);
    }
  }

  /// Through places, from triangle to triangle.
  void add_line(const std::vector<TrianglePoint>& places, bool closed, double step,
                Polylines& to) const {
    std::vector<WayPiece> pieces;
    const std::size_t segments = places.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i) {
      add_pieces(places[i], places[(i + 1) % places.size()], kNoPiece * step, pieces);
    }
    for (const WayPiece& piece : pieces) add_point({piece.triangle, piece.from}, piece.to, to);
    if (closed || pieces.empty()) return;
    add_point({pieces.back().triangle, pieces.back().to}, pieces.back().to, to);
  }

  void add_pieces(const TrianglePoint& from, const TrianglePoint& to, double least,
                  std::vector<WayPiece>& pieces) const {
    std::vector<WayPiece> way;
    if (!ways_.connect(from, to, upward(from, to), way)) {
      const PlacedSegment straight =
          placed_segment(pattern_.mesh, point_in_triangle(pattern_, from).place,
                         point_in_triangle(pattern_, to).place);
      way = {{straight.triangle, straight.from, straight.to}};
    }
    for (const WayPiece& piece : way) {
      const Vector3d along = position_in(pattern_.mesh, {piece.triangle, piece.to}) -
                             position_in(pattern_.mesh, {piece.triangle, piece.from});
      if (along.norm() > least) pieces.push_back(piece);
    }
  }

  Vector3d upward(const TrianglePoint& from, const TrianglePoint& to) const {
    const Vector3d a = point_in_triangle(pattern_, from).normal.cast<double>();
    const Vector3d b = point_in_triangle(pattern_, to).normal.cast<double>();
    return a.dot(b) < 0 ? Vector3d(a - b) : Vector3d(a + b);
  }

  void add_point(const TrianglePoint& place, const std::array<double, 3>& arrival,
                 Polylines& to) const {
    const CurvePoint point = point_in_triangle(pattern_, place);
    to.points.push_back(point.position);
    to.normals.push_back(point.normal);
    to.places.push_back(place);
    to.arrivals.push_back(arrival);
  }

  const StripeCurves& curves_;
  const WavePattern& pattern_;
  std::span<const float> frequencies_;
  double scale_;
  SurfaceWays ways_;
  std::vector<Touch> touches_;
};

void check_faired(const StripeCurves& curves, std::span<const float> frequencies, float scale) {
  if (!(scale > 0 && scale <= 1)) {
    throw Error("curves are faired at a share of the spacing above 0 and at most 1");
  }
  const std::size_t points = curves.lines.points.size();
  if (frequencies.size() != points || curves.lines.arrivals.size() != points) {
    throw Error("faired curves: every point needs a frequency and a place on the mesh");
  }
}

void check_faired_memory(double points) {
  constexpr double kBytes = 2 * (2 * sizeof(Vec3) + sizeof(TrianglePoint) + sizeof(double) * 3);
  const auto remedy = [](double) { return "ask for fewer stripes, or fair at a larger share"; };
  check_fits(points, kBytes, "faired curves", "points", remedy);
  if (points > kMostFairedPoints) {
    throw TooLarge(std::string("faired curves would be more points than brindle can number; ") +
                       remedy(points),
                   kMostFairedPoints / points);
  }
}

template <class Value>
void append_all(const std::vector<Value>& from, std::vector<Value>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

StripeCurves faired_curves(const StripeCurves& curves, const WavePattern& pattern,
                           std::span<const float> frequencies, float scale,
                           const Progress& progress) {
  check_faired(curves, frequencies, scale);
  const std::size_t count = curves.lines.count();
  progress.report(0);
  const Fairer fairer(curves, pattern, frequencies, static_cast<double>(scale));
  check_faired_memory(fairer.point_count());
  std::vector<FairedLine> faired(count);
  parallel_for(
      count, progress,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t line = begin; line < end; ++line) {
          faired[line] = fairer.faired(static_cast<Index>(line));
        }
      },
      1, kLinesPerReport);
  StripeCurves result = curves;
  Polylines& lines = result.lines;
  lines = {};
  lines.origin = curves.lines.origin;
  lines.closed = curves.lines.closed;
  for (FairedLine& line : faired) {
    const Polylines own = std::exchange(line.lines, {});
    append_all(own.points, lines.points);
    append_all(own.normals, lines.normals);
    append_all(own.places, lines.places);
    append_all(own.arrivals, lines.arrivals);
    lines.offsets.push_back(static_cast<Index>(lines.points.size()));
    result.largest_move = std::max(result.largest_move, line.most);
  }
  return result;
}

}  // namespace brindle
