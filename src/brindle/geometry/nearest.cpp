#include "brindle/nearest.h"

#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "brindle/geometry/box_tree.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

/// A point on a triangle with its squared distance from the query.
struct Candidate {
  std::array<double, 3> barycentric{};
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double square = std::numeric_limits<double>::infinity();
};

void take_if_nearer(Candidate& best, const Candidate& other) {
  if (other.square < best.square) best = other;
}

/// Clamps the point to its bounding box, against rounding, and sets its distance.
Candidate measured(Candidate candidate, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper,
                   const Eigen::Vector3d& point) {
  candidate.position = candidate.position.cwiseMax(lower).cwiseMin(upper);
  candidate.square = (candidate.position - point).squaredNorm();
  return candidate;
}

using Corners = std::array<Eigen::Vector3d, 3>;

/// The nearest point on the edge from corner a to corner b.
Candidate nearest_on_edge(const Corners& corners, std::size_t a, std::size_t b,
                          const Eigen::Vector3d& point) {
  const Eigen::Vector3d along = corners[b] - corners[a];
  const double length_square = along.squaredNorm();
  const double share = length_square > 0 ? (point - corners[a]).dot(along) / length_square : 0;
  Candidate found;
  if (!(share > 0)) {
    found.position = corners[a];
    found.barycentric[a] = 1;
  } else if (share >= 1) {
    found.position = corners[b];
    found.barycentric[b] = 1;
  } else {
    found.position = corners[a] + share * along;
    found.barycentric[a] = 1 - share;
    found.barycentric[b] = share;
  }
  return measured(found, corners[a].cwiseMin(corners[b]), corners[a].cwiseMax(corners[b]), point);
}

/// The foot of the perpendicular, if it is in the triangle.
Candidate nearest_inside(const Corners& corners, const Eigen::Vector3d& point) {
  const Eigen::Vector3d ab = corners[1] - corners[0];
  const Eigen::Vector3d ac = corners[2] - corners[0];
  const Eigen::Vector3d ap = point - corners[0];
  const Eigen::Vector3d normal = ab.cross(ac);
  const double square = normal.squaredNorm();
  const double b = ap.cross(ac).dot(normal) / square;
  const double c = ab.cross(ap).dot(normal) / square;
  const double a = 1 - b - c;
  Candidate found;
  if (!(square > 0 && a >= 0 && b >= 0 && c >= 0)) return found;
  found.barycentric = {a, b, c};
  found.position = corners[0] + b * ab + c * ac;
  return measured(found, corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
                  corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]), point);
}

/// Edges come first, from the smaller to the larger number: triangles that share an edge then find
/// the same point, bit for bit.
Candidate nearest_on_triangle(const Mesh& mesh, const Triangle& triangle,
                              const Eigen::Vector3d& point) {
  Corners corners;
  for (std::size_t m = 0; m < 3; ++m) corners[m] = mesh.positions[triangle[m]].cast<double>();
  Candidate best;
  for (std::size_t m = 0; m < 3; ++m) {
    const std::size_t next = (m + 1) % 3;
    const bool forward = triangle[m] < triangle[next];
    take_if_nearer(best, nearest_on_edge(corners, forward ? m : next, forward ? next : m, point));
  }
  take_if_nearer(best, nearest_inside(corners, point));
  return best;
}

/// Squares of larger coordinates may overflow.
constexpr double kFarthest = 1e150;

/// Squared search radius; negative if nothing can be found.
double squared_limit(const Eigen::Vector3d& point, double max_distance) {
  const bool usable = (point.array().abs() <= kFarthest).all();
  return usable && max_distance >= 0 ? max_distance * max_distance : -1;
}

}  // namespace

std::array<double, 3> nearest_in_triangle(const Mesh& mesh, const Triangle& triangle,
                                          const Eigen::Vector3d& point) {
  return nearest_on_triangle(mesh, triangle, point).barycentric;
}

struct NearestOnMesh::State {
  const Mesh& mesh;
  BoxTree tree;
};

NearestOnMesh::NearestOnMesh(const Mesh& mesh, const Progress& progress) {
  check_mesh(mesh);
  const auto box_of_triangle = [&](Index t) {
    return triangle_box(mesh.positions, mesh.triangles[t]);
  };
  state_.reset(new State{mesh, BoxTree(mesh.triangle_count(), box_of_triangle, progress)});
}
NearestOnMesh::~NearestOnMesh() = default;
NearestOnMesh::NearestOnMesh(NearestOnMesh&&) noexcept = default;
NearestOnMesh& NearestOnMesh::operator=(NearestOnMesh&&) noexcept = default;

std::optional<PointOnMesh> NearestOnMesh::nearest(const Eigen::Vector3d& point,
                                                  double max_distance) const {
  const double limit = squared_limit(point, max_distance);
  if (limit < 0) return std::nullopt;
  const Mesh& mesh = state_->mesh;
  const auto found = state_->tree.nearest(point, limit, [&](Index t) {
    return nearest_on_triangle(mesh, mesh.triangles[t], point).square;
  });
  if (!found) return std::nullopt;
  const Candidate best = nearest_on_triangle(mesh, mesh.triangles[found->number], point);
  return PointOnMesh{found->number, best.barycentric, best.position, std::sqrt(best.square)};
}

struct NearestVertex::State {
  const Mesh& mesh;
  BoxTree tree;
};

NearestVertex::NearestVertex(const Mesh& mesh, const Progress& progress) {
  check_positions(mesh.positions);
  const auto box_of_vertex = [&](Index v) {
    return BoundingBox{mesh.positions[v], mesh.positions[v]};
  };
  state_.reset(new State{mesh, BoxTree(mesh.vertex_count(), box_of_vertex, progress)});
}
NearestVertex::~NearestVertex() = default;
NearestVertex::NearestVertex(NearestVertex&&) noexcept = default;
NearestVertex& NearestVertex::operator=(NearestVertex&&) noexcept = default;

std::optional<VertexNearby> NearestVertex::nearest(const Eigen::Vector3d& point,
                                                   double max_distance) const {
  const double limit = squared_limit(point, max_distance);
  if (limit < 0) return std::nullopt;
  const auto found = state_->tree.nearest(point, limit, [&](Index v) {
    return (state_->mesh.positions[v].cast<double>() - point).squaredNorm();
  });
  if (!found) return std::nullopt;
  return VertexNearby{found->number, std::sqrt(found->square)};
}

}  // namespace brindle
