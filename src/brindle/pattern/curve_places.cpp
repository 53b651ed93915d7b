#include "brindle/pattern/curve_places.h"

#include <algorithm>
#include <optional>

#include <Eigen/Geometry>

namespace brindle {
namespace {

using Barycentric = std::array<double, 3>;

/// Nothing if the point is not in the triangle.
std::optional<Barycentric> coordinates_in(const Triangle& triangle, const MeshPoint& point) {
  Barycentric result{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.weights[i] == 0) continue;
    const auto corner = std::find(triangle.begin(), triangle.end(), point.vertices[i]);
    if (corner == triangle.end()) return std::nullopt;
    result[static_cast<std::size_t>(corner - triangle.begin())] += point.weights[i];
  }
  return result;
}

/// Of a point beside the triangle, moved onto it.
Barycentric projected_onto(const Mesh& mesh, const Triangle& triangle, const MeshPoint& point) {
  const auto corner = [&](Index v) -> Eigen::Vector3d { return mesh.positions[v].cast<double>(); };
  const Eigen::Vector3d a = corner(triangle[0]);
  Eigen::Vector3d p = -a;
  for (std::size_t i = 0; i < 3; ++i) p += point.weights[i] * corner(point.vertices[i]);
  const Eigen::Vector3d ab = corner(triangle[1]) - a, ac = corner(triangle[2]) - a;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double square = normal.squaredNorm();
  if (!(square > 0)) return {1, 0, 0};
  Barycentric result{0, std::max(0.0, p.cross(ac).dot(normal) / square),
                     std::max(0.0, ab.cross(p).dot(normal) / square)};
  const double sum = result[1] + result[2];
  result[0] = std::max(0.0, 1 - sum);
  for (double& weight : result) weight /= std::max(1.0, sum);
  return result;
}

}  // namespace

PlacedSegment placed_segment(const Mesh& mesh, const MeshPoint& from, const MeshPoint& to) {
  PlacedSegment best;
  int most = -1;
  for (const Index t : {from.triangles[0], from.triangles[1], to.triangles[0], to.triangles[1]}) {
    const auto start = coordinates_in(mesh.triangles[t], from);
    const auto end = coordinates_in(mesh.triangles[t], to);
    const int inside = int{start.has_value()} + int{end.has_value()};
    if (inside <= most) continue;
    most = inside;
    best = {t, start ? *start : projected_onto(mesh, mesh.triangles[t], from),
            end ? *end : projected_onto(mesh, mesh.triangles[t], to)};
    if (most == 2) break;
  }
  return best;
}

}  // namespace brindle
