#include "brindle/pattern/stripe_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/LU>

#include "brindle/base/elementary.h"

namespace brindle {
namespace {

constexpr double kRadiansPerTurn = 2 * std::numbers::pi;

/// More peaks along one edge would be noise and would exhaust memory.
constexpr double kMostPeaks = 1 << 24;

/// Division that rounds down.
std::int32_t whole_turns(Turns turns) { return static_cast<std::int32_t>(turns >> 24); }

/// A three-sided cell, the triangle itself or a part of it, with all its peaks.
class Cell {
 public:
  struct Side {
    std::uint8_t id = 0;
    bool forward = true;      ///< whether crossings are numbered going around the cell
    std::int32_t passed = 0;  ///< peaks passed going around, in the cell's orientation
    double rise = 0;          ///< turns gained going around, in the cell's orientation
    Turns from = 0, to = 0;   ///< lifted turns at the ends, in the order of crossings
    Index count() const { return static_cast<Index>(std::abs(passed)); }
  };
  using Point = Eigen::Vector3d;  // barycentric in the whole triangle

  /// Pieces that end inside do so at `end`, if it is given.
  Cell(const std::array<Side, 3>& sides, const std::array<Point, 3>& corners, bool join,
       std::vector<StripePiece>& pieces, const std::optional<Point>& end = {})
      : sides_(sides), corners_(corners), join_(join), pieces_(pieces), end_(end) {}

  /// Pairs peaks that are passed upwards with peaks passed downwards, from the corners inwards, so
  /// that no two pieces cross. All pieces touch side c.
  void emit() {
    const std::optional<int> odd = odd_side();
    if (!odd) return emit_ends_of_all();
    const int c = *odd;
    const int b = (c + 1) % 3, a = (c + 2) % 3;
    const Index n_a = sides_[a].count(), n_b = sides_[b].count(), n_c = sides_[c].count();
    const Index x = n_c >= n_a + n_b ? n_a : split(a, b, c);
    const Index y = std::min(n_c - x, n_b);
    for (Index i = 0; i < x; ++i) add(at(c, i), at(a, n_a - 1 - i));
    for (Index i = 0; i < y; ++i) add(at(c, n_c - 1 - i), at(b, i));

    std::vector<PieceEnd> left;
    for (Index i = x; i < n_c - y; ++i) left.push_back(at(c, i));
    for (Index i = y; i < n_b; ++i) left.push_back(at(b, i));
    for (Index i = 0; i + x < n_a; ++i) left.push_back(at(a, i));
    if (left.empty()) return;
    Borders borders;
    if (x > 0) borders.push_back({point(c, x - 1), point(a, n_a - x)});
    if (y > 0) borders.push_back({point(c, n_c - y), point(b, y - 1)});
    emit_ends(left, middle(borders, x > 0, y > 0, c), borders);
  }

 private:
  using Borders = std::vector<std::array<Point, 2>>;

  /// The side whose peaks are passed in the opposite direction to those of the other two; none if
  /// all directions agree. If only two sides have peaks, the one with more.
  std::optional<int> odd_side() const {
    for (int c = 0; c < 3; ++c) {
      const Side& a = sides_[(c + 2) % 3];
      const Side& b = sides_[(c + 1) % 3];
      const auto against = [&](const Side& other) {
        return (sides_[c].passed > 0) != (other.passed > 0) || other.passed == 0;
      };
      if (sides_[c].passed == 0 || !against(a) || !against(b)) continue;
      if (a.passed == 0 && b.passed == 0) continue;
      if (sides_[c].count() >= a.count() + b.count() || (a.passed != 0 && b.passed != 0)) return c;
    }
    return {};
  }

  /// The number of side c's peaks to join with side a, from their common corner; the others join
  /// side b. The choice gives pieces closest to level lines of the linear function that spreads the
  /// closing error evenly over the sides.
  Index split(int a, int b, int c) const {
    const Index n_a = sides_[a].count(), n_b = sides_[b].count(), n_c = sides_[c].count();
    const Index first = n_c > n_b ? n_c - n_b : 0;
    const Index last = std::min(n_a, n_c);
    Index best = first;
    double error = 0, least = 0;
    for (Index x = first; x < last; ++x) {
      const double level = height(point(c, x));
      error += std::abs(level - height(point(a, n_a - 1 - x)));
      error -= std::abs(level - height(point(b, n_c - 1 - x)));
      if (error >= least) continue;
      least = error;
      best = x + 1;
    }
    return best;
  }

  double height(const Point& p) const {
    const double closing = (sides_[0].rise + sides_[1].rise + sides_[2].rise) / 3;
    const std::array<double, 3> h = {0, sides_[0].rise - closing,
                                     sides_[0].rise + sides_[1].rise - 2 * closing};
    // Corners are linearly independent as barycentric coordinates.
    Eigen::Matrix3d corner;
    corner << corners_[0], corners_[1], corners_[2];
    return corner.partialPivLu().solve(p).dot(Eigen::Vector3d(h[0], h[1], h[2]));
  }

  /// The position of side m's i-th crossing, going around, as a share of the side's length.
  double share(int m, Index i) const {
    const Side& side = sides_[m];
    if (side.forward) return crossing_position(side.from, side.to, i);
    return 1 - crossing_position(side.from, side.to, side.count() - 1 - i);
  }
  Point point(int m, Index i) const {
    const double t = share(m, i);
    return (1 - t) * corners_[m] + t * corners_[(m + 1) % 3];
  }
  PieceEnd at(int m, Index i) const {
    const Side& side = sides_[m];
    const Point p = point(m, i);
    return {side.id, side.forward ? i : side.count() - 1 - i, {p[0], p[1], p[2]}};
  }

  void add(const PieceEnd& from, const PieceEnd& to) {
    pieces_.push_back({{from, to}, sides_[0].id});
  }

  /// The middle of the area that the outermost pieces leave free: the mean of its corners.
  Point middle(const Borders& borders, bool cut_off_c, bool cut_off_b, int c) const {
    Point sum = corners_[(c + 2) % 3];
    double count = 1;
    const auto take = [&](const Point& p) { sum += p, ++count; };
    for (const auto& border : borders) take(border[0]), take(border[1]);
    if (!cut_off_c) take(corners_[c]);
    if (!cut_off_b) take(corners_[(c + 1) % 3]);
    return sum / count;
  }

  void emit_ends_of_all() {
    std::vector<PieceEnd> left;
    for (int m = 0; m < 3; ++m) {
      for (Index i = 0; i < sides_[m].count(); ++i) left.push_back(at(m, i));
    }
    emit_ends(left, (corners_[0] + corners_[1] + corners_[2]) / 3, {});
  }

  /// `left` is in order around the cell, between the borders.
  void emit_ends(const std::vector<PieceEnd>& left, const Point& middle, const Borders& borders) {
    const Point end = end_.value_or(middle);
    std::size_t next = 0;
    for (; join_ && next + 1 < left.size(); next += 2) add(left[next], left[next + 1]);
    for (; next < left.size(); ++next) {
      const Point p = join_ ? continued(left[next], end, borders) : end;
      add(left[next], {PieceEnd::kInside, 0, {p[0], p[1], p[2]}});
    }
  }

  /// The middle of the nearest border, or `end` if there is none.
  static Point continued(const PieceEnd& from, const Point& end, const Borders& borders) {
    const Point start(from.barycentric[0], from.barycentric[1], from.barycentric[2]);
    Point nearest = end;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& border : borders) {
      const Point middle = (border[0] + border[1]) / 2;
      if ((middle - start).norm() >= least) continue;
      least = (middle - start).norm();
      nearest = middle;
    }
    return nearest;
  }

  std::array<Side, 3> sides_;
  std::array<Point, 3> corners_;
  bool join_;
  std::vector<StripePiece>& pieces_;
  std::optional<Point> end_;
};

/// The signs that orient the corners' waves like corner 0, across its two edges.
std::array<int, 3> senses(const LiftedTriangle& triangle) {
  return {1, triangle.edges[0].reflecting ? -1 : 1, triangle.edges[2].reflecting ? -1 : 1};
}

/// Edge m going around, in an orientation where the waves of corners m and m + 1 have the signs
/// `here` and `there`.
Cell::Side edge_side(const LiftedTriangle& triangle, int m, int here, int there) {
  const int next = (m + 1) % 3;
  const EdgeLift& lift = triangle.edges[m];
  const bool forward = triangle.forward[m];
  const int sign = forward ? here : -there;
  const Turns from = triangle.turns[forward ? m : next];
  const Turns to = lifted_end(lift, triangle.turns[forward ? next : m]);
  return {static_cast<std::uint8_t>(m),
          forward,
          sign * lift.peaks,
          sign * static_cast<double>(to - from) / kWholeTurn,
          from,
          to};
}

/// The cut from a corner inwards (`out`: outwards), where the corner's wave has the given sign.
Cell::Side cut_side(const LiftedTriangle& triangle, int corner, int sign, bool out) {
  const Turns from = triangle.turns[corner];
  const Turns to = triangle.inner[corner];
  const int way = out ? -sign : sign;
  return {static_cast<std::uint8_t>(3 + corner),
          !out,
          way * whole_turns(to),
          way * static_cast<double>(to - from) / kWholeTurn,
          from,
          to};
}

/// Sets `inner` of a field singularity. Once around it, the phase returns reversed, up to whole
/// turns. Half of these turns is the only phase that equals its own reverse: a peak or a trough.
void reach_inside(LiftedTriangle& triangle) {
  // Oriented like the first corner, the phase at corner m is sense[m] * turns + gained[m].
  std::array<int, 4> sense = {1};
  std::array<Turns, 4> gained{};
  for (int m = 0; m < 3; ++m) {
    const EdgeLift& lift = triangle.edges[m];
    const Turns end = lifted_end(lift, 0);
    sense[m + 1] = lift.reflecting ? -sense[m] : sense[m];
    gained[m + 1] = gained[m] + (triangle.forward[m] || lift.reflecting ? end : -end) * sense[m];
  }
  const Turns centre = gained[3] / 2;
  std::array<Turns, 4> way{};  // to the centre, oriented like the first corner
  for (int m = 0; m < 3; ++m) {
    triangle.inner[m] = sense[m] * (centre - gained[m]);
    way[m] = centre - gained[m] - sense[m] * triangle.turns[m];
  }
  if (centre % kWholeTurn != 0) return;

  // Each part whose two corners lie on opposite sides of the peak has a curve to the barycentre.
  way[3] = -way[0];
  int curves = 0;
  for (int m = 0; m < 3; ++m) curves += (way[m] > 0) != (way[m + 1] > 0);
  const auto shortest = std::min_element(
      way.begin(), way.begin() + 3, [](Turns a, Turns b) { return std::abs(a) < std::abs(b); });
  for (int m = 0; m < 3; ++m) {
    const bool beyond = curves == 3 && m == shortest - way.begin();
    triangle.inner[m] += (way[m] * sense[m] > 0) == beyond ? 1 : -1;
  }
}

}  // namespace

CornerWave canonical(const CornerWave& corner) {
  const Vec3& d = corner.wave.direction;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] != 0) return d[axis] < 0 ? flipped(corner) : corner;
  }
  return corner;
}

Turns turns_after_peak(Complex z) {
  const double turns = elementary::atan2(z.imag(), z.real()) / kRadiansPerTurn - 0.25;
  const Turns rounded = std::llround((turns - std::floor(turns)) * static_cast<double>(kWholeTurn));
  return std::clamp<Turns>(rounded, 1, kWholeTurn - 1);
}

EdgeLift lift_edge(const CornerWave& first, Turns first_turns, const CornerWave& second,
                   Turns second_turns, PhaseShiftKind kind) {
  EdgeLift lift;
  Wave end = second.wave;
  if (first.wave.direction.dot(end.direction) < 0) {
    lift.reflecting = true;
    end.direction = -end.direction;
    second_turns = kWholeTurn - second_turns;
  }
  const double shift = phase_shift(kind, first.wave, end).radians / kRadiansPerTurn;
  const double peaks =
      shift + static_cast<double>(first_turns - second_turns) / static_cast<double>(kWholeTurn);
  lift.peaks = static_cast<std::int32_t>(std::lround(std::clamp(peaks, -kMostPeaks, kMostPeaks)));
  return lift;
}

LiftedTriangle lifted_triangle(const Triangle& triangle, const std::array<Turns, 3>& turns,
                               const std::array<EdgeLift, 3>& edges) {
  LiftedTriangle result;
  result.turns = turns;
  result.edges = edges;
  for (int m = 0; m < 3; ++m) result.forward[m] = triangle[m] < triangle[(m + 1) % 3];
  if (edges[0].reflecting ^ edges[1].reflecting ^ edges[2].reflecting) {
    result.kind = TriangleKind::field_singularity;
    reach_inside(result);
    return result;
  }
  const std::array<int, 3> sense = senses(result);
  for (int m = 0; m < 3; ++m) {
    const int sign = result.forward[m] ? sense[m] : -sense[(m + 1) % 3];
    result.branch_index += sign * edges[m].peaks;
  }
  result.kind = result.branch_index == 0 ? TriangleKind::regular : TriangleKind::branch;
  return result;
}

double crossing_position(Turns from, Turns to, Index number) {
  const Turns peak = (to > from ? Turns{number} + 1 : -Turns{number}) * kWholeTurn;
  return static_cast<double>(peak - from) / static_cast<double>(to - from);
}

void stripe_pieces(const LiftedTriangle& triangle, bool join, std::vector<StripePiece>& pieces) {
  pieces.clear();
  const bool no_peaks =
      triangle.edges[0].peaks == 0 && triangle.edges[1].peaks == 0 && triangle.edges[2].peaks == 0;
  const bool singular = triangle.kind == TriangleKind::field_singularity;
  if (triangle.kind == TriangleKind::no_wave || (no_peaks && !singular)) return;
  const std::array<Cell::Point, 3> corner = {Cell::Point::UnitX(), Cell::Point::UnitY(),
                                             Cell::Point::UnitZ()};
  if (!singular) {
    const std::array<int, 3> sense = senses(triangle);
    std::array<Cell::Side, 3> sides;
    for (int m = 0; m < 3; ++m) sides[m] = edge_side(triangle, m, sense[m], sense[(m + 1) % 3]);
    return Cell(sides, corner, join, pieces).emit();
  }
  const Cell::Point barycentre = Cell::Point::Constant(1.0 / 3);
  for (int m = 0; m < 3; ++m) {
    const int next = (m + 1) % 3;
    const int there = triangle.edges[m].reflecting ? -1 : 1;
    const std::array<Cell::Side, 3> sides = {edge_side(triangle, m, 1, there),
                                             cut_side(triangle, next, there, false),
                                             cut_side(triangle, m, 1, true)};
    Cell(sides, {corner[m], corner[next], barycentre}, join, pieces, barycentre).emit();
  }
}

}  // namespace brindle
