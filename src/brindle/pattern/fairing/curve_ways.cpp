#include "brindle/pattern/fairing/curve_ways.h"

#include <array>

#include "brindle/pattern/cut_curves.h"

namespace brindle {
namespace {

void add_point_at(const WavePattern& pattern, const TrianglePoint& place,
                  const std::array<double, 3>& arrival, Polylines& to) {
  const CurvePoint point = point_in_triangle(pattern, place);
  to.points.push_back(point.position);
  to.normals.push_back(point.normal);
  to.places.push_back(place);
  to.arrivals.push_back(arrival);
}

}  // namespace

void add_way(const WavePattern& pattern, const SurfaceWays& ways, const TrianglePoint& from,
             const TrianglePoint& to, double least, std::vector<SurfaceWays::Piece>& pieces) {
  const CurvePoint start = point_in_triangle(pattern, from), end = point_in_triangle(pattern, to);
  // Normals of unorientable surfaces may point either way.
  const float sign = start.normal.dot(end.normal) < 0 ? -1.0f : 1.0f;
  const Vec3 upward = start.normal + sign * end.normal;
  std::vector<SurfaceWays::Piece> way;
  if (!ways.connect(from, to, upward.cast<double>(), way)) {
    const PlacedSegment straight = placed_segment(pattern.mesh, start.place, end.place);
    way = {{straight.triangle, straight.from, straight.to}};
  }
  for (const SurfaceWays::Piece& piece : way) {
    const Eigen::Vector3d along = position_in(pattern.mesh, {piece.triangle, piece.to}) -
                                  position_in(pattern.mesh, {piece.triangle, piece.from});
    if (along.norm() > least) pieces.push_back(piece);
  }
}

void add_points_of(const WavePattern& pattern, const std::vector<SurfaceWays::Piece>& pieces,
                   bool closed, Polylines& to) {
  for (const SurfaceWays::Piece& piece : pieces) {
    add_point_at(pattern, {piece.triangle, piece.from}, piece.to, to);
  }
  if (closed || pieces.empty()) return;
  const SurfaceWays::Piece& last = pieces.back();
  add_point_at(pattern, {last.triangle, last.to}, last.to, to);
}

std::vector<SurfaceWays::Piece> pieces_of(const Polylines& lines, Index line) {
  std::vector<SurfaceWays::Piece> pieces;
  const Index end = lines.offsets[line + 1] - (lines.closed[line] ? 0 : 1);
  for (Index i = lines.offsets[line]; i < end; ++i) {
    pieces.push_back({lines.places[i].triangle, lines.places[i].barycentric, lines.arrivals[i]});
  }
  return pieces;
}

}  // namespace brindle
