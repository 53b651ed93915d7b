#include "brindle/pattern/lifted_waves.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/nearest.h"

namespace brindle {
namespace {

void check_sizes(const WavePattern& pattern) {
  const std::size_t count = pattern.mesh.vertex_count();
  const WaveSet& waves = pattern.waves;
  if (waves.positions.size() != count || waves.directions.size() != count ||
      waves.frequencies.size() != count || pattern.z.size() != count ||
      pattern.normals.size() != count) {
    throw Error("curves need one wave, one phase and one normal per vertex");
  }
  if (pattern.edges.of_triangle.size() != pattern.mesh.triangle_count()) {
    throw Error("the edges are not those of this mesh");
  }
}

}  // namespace

LiftedWaves::LiftedWaves(const WavePattern& pattern, const Progress& progress) : pattern_(pattern) {
  check_sizes(pattern);
  const WaveSet& waves = pattern.waves;
  waves_.resize(pattern.mesh.vertex_count());
  turns_.resize(waves_.size());
  parallel_for(waves_.size(), progress.part(0, 0.3), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      waves_[v] = canonical({waves.wave(v), pattern.z[v]});
      turns_[v] = waves.directions[v].isZero(0) ? 0 : turns_after_peak(waves_[v].z);
    }
  });
  const auto& vertices = pattern.edges.vertices;
  edges_.resize(vertices.size());
  parallel_for(vertices.size(), progress.part(0.3, 1), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto [a, b] = vertices[e];
      if (turns_[a] == 0 || turns_[b] == 0) continue;
      edges_[e] = lift_edge(waves_[a], turns_[a], waves_[b], turns_[b], pattern.phase_shift);
    }
  });
}

LiftedTriangle LiftedWaves::triangle(std::size_t t) const {
  const Triangle& vertices = pattern_.mesh.triangles[t];
  std::array<Turns, 3> turns{};
  std::array<EdgeLift, 3> edges;
  for (int m = 0; m < 3; ++m) {
    turns[m] = turns_[vertices[m]];
    if (turns[m] == 0) return {};
    edges[m] = edges_[pattern_.edges.of_triangle[t][m]];
  }
  return lifted_triangle(vertices, turns, edges);
}

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
