#include "brindle/pattern/fairing/curve_segments.h"

#include <Eigen/Geometry>

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

}  // namespace brindle
