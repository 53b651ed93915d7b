#include "brindle/pattern/fairing/curve_segments.h"

#include <array>

#include <Eigen/Geometry>

#include "brindle/pattern/lifted_waves.h"

namespace brindle {
namespace {

std::vector<CurveSegment> segments_of_all(const Polylines& lines) {
  std::vector<CurveSegment> segments;
  for (Index line = 0; line < lines.count(); ++line) {
    const Index count = lines.offsets[line + 1] - lines.offsets[line];
    for (Index i = 0; i + (lines.closed[line] ? 0 : 1) < count; ++i) segments.push_back({line, i});
  }
  return segments;
}

void add_point_at(const WavePattern& pattern, const TrianglePoint& place,
                  const std::array<double, 3>& arrival, Polylines& to) {
  const CurvePoint point = point_in_triangle(pattern, place);
  to.add(point.position, point.normal, place, arrival);
}

}  // namespace

CurveSegments::CurveSegments(const Polylines& lines, const Progress& progress)
    : lines_(lines),
      segments_(segments_of_all(lines)),
      tree_(
          segments_.size(),
          [&](Index number) {
            const auto [a, b] = ends_of(segments_[number]);
            return BoundingBox{a.cwiseMin(b), a.cwiseMax(b)};
          },
          progress) {}

std::array<Vec3, 2> CurveSegments::ends_of(const CurveSegment& segment) const {
  const auto points = lines_.points_of(segment.line);
  return {points[segment.number], points[(segment.number + 1) % points.size()]};
}

std::optional<CurveSegments::Crossing> CurveSegments::crossing(
    const CurveSegment& segment, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
    const Eigen::Vector3d& upward) const {
  const auto [a, b] = ends_of(segment);
  const Eigen::Vector3d start = a.cast<double>() - from, other = (b - a).cast<double>();
  const Eigen::Vector3d way = to - from;
  const double size = upward.dot(way.cross(other));
  if (size == 0) return std::nullopt;
  const Crossing found{upward.dot(start.cross(way)) / size, upward.dot(start.cross(other)) / size};
  const auto within = [](double share) { return share >= 0 && share <= 1; };
  if (!within(found.share) || !within(found.along)) return std::nullopt;
  const Eigen::Vector3d apart = start + found.share * other - found.along * way;
  return apart.norm() <= way.norm() ? std::optional(found) : std::nullopt;
}

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
