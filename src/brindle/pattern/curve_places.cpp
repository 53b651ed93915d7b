#include "brindle/pattern/curve_places.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "brindle/nearest.h"

namespace brindle {
namespace {

using Barycentric = std::array<double, 3>;

/// The point's barycentric coordinates; nullopt if it is not in the triangle.
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

Eigen::Vector3d position_of(const Mesh& mesh, const std::array<Index, 3>& vertices,
                            const Barycentric& weights) {
  // Relative to the first vertex, to keep precision far from the origin.
  const auto at = [&](Index v) -> Eigen::Vector3d { return mesh.positions[v].cast<double>(); };
  const Eigen::Vector3d first = at(vertices[0]);
  return first + weights[1] * (at(vertices[1]) - first) + weights[2] * (at(vertices[2]) - first);
}

/// A point moved into a triangle, and the distance.
struct Moved {
  Barycentric barycentric{};
  double distance = 0;
};

Moved placed_in(const Mesh& mesh, const Triangle& triangle, const MeshPoint& point) {
  if (const auto inside = coordinates_in(triangle, point)) return {*inside, 0};
  const Eigen::Vector3d from = position_of(mesh, point.vertices, point.weights);
  const Barycentric there = nearest_in_triangle(mesh, triangle, from);
  return {there, (position_of(mesh, triangle, there) - from).norm()};
}

/// Sets weights that are rounding errors to zero.
std::array<double, 3> cleaned(std::array<double, 3> barycentric) {
  double sum = 0;
  for (double& weight : barycentric) {
    if (weight < 1e-12) weight = 0;
    sum += weight;
  }
  for (double& weight : barycentric) weight /= sum;
  return barycentric;
}

}  // namespace

void add_normal(const WavePattern& pattern, float weight, Index vertex, Vec3& sum) {
  const Vec3& normal = pattern.normals[vertex];
  sum += (sum.dot(normal) < 0 ? -weight : weight) * normal;
}

CurvePoint point_in_triangle(const WavePattern& pattern, const TrianglePoint& place) {
  const Triangle& triangle = pattern.mesh.triangles[place.triangle];
  const Vec3& first = pattern.mesh.positions[triangle[0]];
  CurvePoint result{first,
                    Vec3::Zero(),
                    Vec3::Zero(),
                    0,
                    {triangle, cleaned(place.barycentric), {place.triangle, place.triangle}}};
  for (int m = 0; m < 3; ++m) {
    const auto weight = static_cast<float>(place.barycentric[m]);
    const Vec3 side = pattern.mesh.positions[triangle[m]] - first;
    result.position += weight * side;
    result.size = std::max(result.size, side.norm());
    add_normal(pattern, weight, triangle[m], result.normal);
  }
  result.normal.stableNormalize();
  return result;
}

PlacedSegment placed_segment(const Mesh& mesh, const MeshPoint& from, const MeshPoint& to) {
  PlacedSegment best;
  double least = std::numeric_limits<double>::infinity();
  for (const Index t : {from.triangles[0], from.triangles[1], to.triangles[0], to.triangles[1]}) {
    const Moved start = placed_in(mesh, mesh.triangles[t], from);
    const Moved end = placed_in(mesh, mesh.triangles[t], to);
    const double moved = start.distance + end.distance;
    if (moved >= least) continue;
    least = moved;
    best = {t, start.barycentric, end.barycentric};
    if (moved == 0) break;
  }
  return best;
}

}  // namespace brindle
