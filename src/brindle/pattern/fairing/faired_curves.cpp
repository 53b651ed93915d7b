#include "brindle/pattern/fairing/faired_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/surface_walk.h"
#include "brindle/pattern/fairing/smooth_forks.h"
#include "brindle/pattern/fairing/unrolled_curve.h"
#include "brindle/pattern/stripe_curves.h"

namespace brindle {
namespace {

using Eigen::Vector3d;

constexpr double kSamplesPerScale = 4;
/// How far a closed curve is unrolled beyond its start on both sides, times the scale. Points
/// farther away have no effect at the start.
constexpr int kBeyondStart = 8;
/// The share of the bound at which deviations are aimed, so that few rounds suffice.
constexpr double kAlmost = 0.97;
constexpr double kHeld = 1e6;  // weight of fixed samples
constexpr std::array<double, 2> kAllLoose = {std::numeric_limits<double>::infinity(),
                                             std::numeric_limits<double>::infinity()};
constexpr int kMostRounds = 20;
constexpr double kNoPiece = 1e-4;  // shorter pieces are omitted; over the sample distance
constexpr double kMostFairedPoints = 0xfffffff0;  // points are numbered by Index
constexpr std::size_t kLinesPerReport = 32;

/// Finds the deviations y of equidistant samples x that minimise the sum of weight |y|^2 +
/// stiffness |second difference of x + y|^2. The deviations of the two ends are given.
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

  /// Solves by the L D L^T factors of a pentadiagonal matrix.
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
    double diagonal = 0, first = 0, second = 0;  ///< of D and L
    PlanePoint right = 0;
  };
  double stiffness_;
  std::vector<PlanePoint> y_, right_;
  std::vector<Row> rows_;
};

/// Deviations of samples over the allowed ones; each sample gets the largest value nearby.
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

/// Shortens the spline's length where samples would move too far. Corners move in proportion to
/// this length, whose fourth power is the stiffness over the weight.
std::vector<PlanePoint> bounded_deviations(std::span<const UnrolledPlace> places, double stiffness,
                                           const std::array<PlanePoint, 2>& ends,
                                           std::vector<double> weights) {
  std::vector<PlanePoint> points;
  for (const UnrolledPlace& place : places) points.push_back(place.point);
  SmoothingSpline spline(points, stiffness, ends);
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

/// Constraints of an open curve: the moves of its ends, and the distances from them, in periods,
/// within which it may move.
struct Given {
  std::array<PlanePoint, 2> moves{};
  std::array<double, 2> loose = kAllLoose;
};

/// A sample of a curve and its displacement.
struct MovedSample {
  UnrolledPlace place;
  PlanePoint by;  ///< in the unrolled plane
};

/// The samples of a curve; the first of a closed curve is not repeated at the end.
std::vector<MovedSample> moved_samples(const UnrolledCurve& curve, double scale,
                                       const Given& given) {
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
  std::vector<double> weights(places.size(), 1.0);
  for (std::int64_t i = 0; i <= steps && !curve.closed(); ++i) {
    const double passed = static_cast<double>(i) * step, left = periods - passed;
    const bool held = passed > given.loose[0] && left > given.loose[1];
    if (held) weights[static_cast<std::size_t>(i)] = kHeld;
  }
  const auto deviations =
      bounded_deviations(places, std::pow(scale / step, 4), given.moves, weights);
  std::vector<MovedSample> samples;
  const auto first = static_cast<std::size_t>(beyond);
  const std::size_t kept = static_cast<std::size_t>(steps) + (curve.closed() ? 0 : 1);
  for (std::size_t i = first; i < first + kept; ++i) samples.push_back({places[i], deviations[i]});
  return samples;
}

/// The displacements of a curve's ends, in space.
using EndMoves = std::array<std::optional<Vector3d>, 2>;

struct FairedLine {
  std::vector<SurfaceWays::Piece> pieces;
  double most = 0;  ///< largest move of a point, times f
};

class Fairer {
 public:
  Fairer(const WavePattern& pattern, double scale)
      : pattern_(pattern), scale_(scale), ways_(pattern.mesh, pattern.edges) {}

  const SurfaceWays& ways() const { return ways_; }

  /// Fairs a curve. `moves` displaces its ends with the curves that they touch; the curve may move
  /// within `loose` periods from its ends.
  FairedLine faired(const std::vector<SurfaceWays::Piece>& own, bool closed,
                    const EndMoves& moves = {},
                    const std::array<double, 2>& loose = kAllLoose) const {
    FairedLine result;
    const Polylines line = line_of(own, closed);
    const std::vector<float> frequencies = frequencies_along(pattern_, line);
    const UnrolledCurve curve(pattern_.mesh, line, 0, frequencies);
    // Unrolling would go around a tiny closed curve many times.
    const bool is_short = closed && curve.periods() < scale_;
    if (is_short || !(curve.periods() > 0)) return {own};
    std::array<PlanePoint, 2> ends{};
    for (const std::size_t end : {0u, 1u}) {
      if (moves[end]) ends[end] = curve.in_plane(end == 0 ? 0 : own.size() - 1, *moves[end]);
    }
    const auto samples = moved_samples(curve, scale_, {ends, loose});
    std::vector<TrianglePoint> places;
    for (const MovedSample& sample : samples) {
      places.push_back(
          ways_.straight_on(sample.place.place, curve.in_space(sample.place.segment, sample.by)));
      result.most = std::max(result.most, std::abs(sample.by) * sample.place.frequency);
    }
    const double least = kNoPiece * curve.length() / static_cast<double>(samples.size());
    const std::size_t segments = places.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i) {
      add_way(pattern_, ways_, places[i], places[(i + 1) % places.size()], least, result.pieces);
    }
    // A curve that would shrink to a point stays unchanged.
    if (result.pieces.empty()) return {own};
    return result;
  }

  /// The displacement of the place `periods` along a curve.
  Vector3d move_at(const UnrolledCurve& curve, std::size_t segment, double periods) const {
    const std::vector<MovedSample> samples = moved_samples(curve, scale_, {});
    const auto steps = static_cast<double>(samples.size() - (curve.closed() ? 0 : 1));
    const double at = std::clamp(periods / curve.periods() * steps, 0.0, steps);
    const auto before = std::min(static_cast<std::size_t>(at), samples.size() - 1);
    const std::size_t after = std::min(before + 1, samples.size() - 1);
    const double share = at - static_cast<double>(before);
    return curve.in_space(segment, (1 - share) * samples[before].by + share * samples[after].by);
  }

 private:
  Polylines line_of(const std::vector<SurfaceWays::Piece>& pieces, bool closed) const {
    Polylines line;
    add_points_of(pattern_, pieces, closed, line);
    line.end_line(closed);
    return line;
  }

  const WavePattern& pattern_;
  double scale_;
  SurfaceWays ways_;
};

void check_faired(const StripeCurves& curves, float scale) {
  if (!(scale > 0 && scale <= 1)) {
    throw Error("curves are faired at a share of the spacing above 0 and at most 1");
  }
  if (curves.lines.arrivals.size() != curves.lines.points.size()) {
    throw Error("faired curves: every point needs a place on the mesh");
  }
}

void check_faired_memory(double points) {
  constexpr double kBytes = 560;  // measured, with forks
  const auto remedy = [](double) { return "ask for fewer stripes, or fair at a larger share"; };
  check_fits(points, kBytes, "faired curves", "points", remedy);
  if (points > kMostFairedPoints) {
    throw TooLarge(std::string("faired curves would be more points than brindle can number; ") +
                       remedy(points),
                   kMostFairedPoints / points);
  }
}

/// The approximate number of points of all faired curves.
double faired_points(const Polylines& lines, std::span<const float> frequencies, double scale) {
  auto points = static_cast<double>(lines.points.size());
  for (Index line = 0; line < lines.count(); ++line) {
    points += periods_of(lines, line, frequencies) * kSamplesPerScale / scale;
  }
  return points;
}

/// The displacements of ends that lie on other curves, by line.
std::vector<EndMoves> moves_of(const std::vector<TouchingEnd>& touches, const Polylines& lines,
                               const Mesh& mesh, std::span<const float> frequencies,
                               const Fairer& fairer, const Progress& progress) {
  std::vector<Vector3d> moves(touches.size());
  parallel_for(
      touches.size(), progress,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const UnrolledCurve other(mesh, lines, touches[i].other, frequencies);
          moves[i] = fairer.move_at(other, touches[i].segment, touches[i].periods);
        }
      },
      1, kLinesPerReport);
  std::vector<EndMoves> of_lines(lines.count());
  for (std::size_t i = 0; i < touches.size(); ++i) {
    of_lines[touches[i].line][touches[i].end] = moves[i];
  }
  return of_lines;
}

StripeCurves with_lines(const StripeCurves& curves, const std::vector<FairedLine>& faired,
                        const WavePattern& pattern) {
  StripeCurves result = curves;
  Polylines& lines = result.lines;
  lines = {};
  lines.origin = curves.lines.origin;
  lines.closed = curves.lines.closed;
  for (std::size_t line = 0; line < faired.size(); ++line) {
    add_points_of(pattern, faired[line].pieces, lines.closed[line], lines);
    lines.offsets.push_back(static_cast<Index>(lines.points.size()));
    result.largest_move = std::max(result.largest_move, faired[line].most);
  }
  return result;
}

/// Adds forks at these ends to curves that are already fair, so forks do not affect other curves.
StripeCurves with_forks(const StripeCurves& curves, const std::vector<TouchingEnd>& touches,
                        const WavePattern& pattern, const Fairer& fairer,
                        const Progress& progress) {
  const Polylines& lines = curves.lines;
  const JunctionSmoother maker(curves, touches, pattern, fairer.ways(), progress.part(0, 0.5));
  std::vector<FairedLine> forked(lines.count());
  std::vector<std::size_t> forks(lines.count());
  parallel_for(
      lines.count(), progress.part(0.5, 1),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto line = static_cast<Index>(i);
          forked[i].pieces = maker.forked(line);
          forks[i] = maker.smooth_forks_of(line);
          std::array<double, 2> loose = maker.forks_of(line);
          for (double& length : loose) {
            if (length > 0) length += kBeforeFork;
          }
          if (loose == std::array<double, 2>{}) continue;
          forked[i].pieces = fairer.faired(forked[i].pieces, false, {}, loose).pieces;
        }
      },
      1, kLinesPerReport);
  StripeCurves result = with_lines(curves, forked, pattern);
  for (const std::size_t count : forks) result.smooth_forks += count;
  return result;
}

}  // namespace

StripeCurves faired_curves(const StripeCurves& curves, const WavePattern& pattern, float scale,
                           const Progress& progress) {
  check_faired(curves, scale);
  const Polylines& lines = curves.lines;
  const std::vector<float> frequencies = frequencies_along(pattern, lines);
  check_faired_memory(faired_points(lines, frequencies, static_cast<double>(scale)));
  JobStages stages(progress, {{"ends", 1}, {"curves", 3}, {"forks", 2}});
  const Progress ends = stages.begin("ends");
  ends.report(0);
  const Fairer fairer(pattern, static_cast<double>(scale));
  const std::vector<TouchingEnd> touches = touching_ends(curves, pattern.mesh, frequencies);
  const auto moves = moves_of(touches, lines, pattern.mesh, frequencies, fairer, ends);
  std::vector<FairedLine> faired(lines.count());
  parallel_for(
      faired.size(), stages.begin("curves"),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto pieces = pieces_of(lines, static_cast<Index>(i));
          faired[i] = fairer.faired(pieces, lines.closed[i], moves[i]);
        }
      },
      1, kLinesPerReport);
  StripeCurves result = with_lines(curves, faired, pattern);
  const Progress forking = stages.begin("forks");
  if (curves.ends_at_neighbors > 0) result = with_forks(result, touches, pattern, fairer, forking);
  stages.finish();
  return result;
}

}  // namespace brindle
