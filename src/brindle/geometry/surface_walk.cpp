#include "brindle/geometry/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

namespace brindle {
namespace {

using Eigen::Vector3d;

constexpr int kMostPassed = 4096;  // triangles on one path

Vector3d vector_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
std::array<double, 3> array_of(const Vector3d& v) { return {v[0], v[1], v[2]}; }

/// Clamps rounding errors beyond the edges.
TrianglePoint inside(Index triangle, Vector3d place) {
  place = place.cwiseMax(0.0);
  return {triangle, array_of(place / place.sum())};
}

std::array<double, 2> weights_on(const SurfaceWalker& walker, const Triangle& triangle, int edge) {
  std::array<double, 2> between = {walker.place[edge], walker.place[(edge + 1) % 3]};
  if (triangle[edge] > triangle[(edge + 1) % 3]) std::swap(between[0], between[1]);
  return between;
}

/// The plane that contains a path, and the progress of points along it.
struct CuttingPlane {
  Vector3d start, along, normal;

  /// Its sign is the side; 0 counts as positive.
  double side(const Vector3d& p) const { return normal.dot(p - start); }
  /// 0 at the start, 1 at the goal.
  double share(const Vector3d& p) const { return along.dot(p - start) / along.squaredNorm(); }
};

/// The edge by which a plane leaves a triangle.
struct Leaving {
  int edge;
  double share;  ///< position on the edge, from its first corner
  double passed;
};

std::optional<Leaving> leaving(const CuttingPlane& plane, const std::array<Vector3d, 3>& corners,
                               int entered) {
  std::optional<Leaving> best;
  for (int m = 0; m < 3; ++m) {
    const int next = (m + 1) % 3;
    const double a = plane.side(corners[m]), b = plane.side(corners[next]);
    if (m == entered || (a < 0) == (b < 0)) continue;
    const double share = a / (a - b);
    const double passed = plane.share(corners[m] + share * (corners[next] - corners[m]));
    if (!best || passed > best->passed) best = {m, share, passed};
  }
  return best;
}

}  // namespace

std::array<Vector3d, 3> corners_of(const Mesh& mesh, std::size_t triangle) {
  std::array<Vector3d, 3> corners;
  for (int m = 0; m < 3; ++m) {
    corners[m] = mesh.positions[mesh.triangles[triangle][m]].cast<double>();
  }
  return corners;
}

Vector3d position_in(const Mesh& mesh, const TrianglePoint& place) {
  const auto corners = corners_of(mesh, place.triangle);
  return corners[0] + place.barycentric[1] * (corners[1] - corners[0]) +
         place.barycentric[2] * (corners[2] - corners[0]);
}

Vector3d normal_of(const std::array<Vector3d, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

Vector3d change_along(const std::array<Vector3d, 3>& corners, const Vector3d& direction) {
  const Vector3d normal = normal_of(corners);
  Vector3d change;
  for (int m = 0; m < 3; ++m) {
    const Vector3d opposite = corners[(m + 2) % 3] - corners[(m + 1) % 3];
    change[m] = normal.cross(opposite).dot(direction) / normal.squaredNorm();
  }
  return change;
}

WayOut way_out(const SurfaceWalker& walker, const Vector3d& change) {
  WayOut out{std::numeric_limits<double>::infinity(), -1};
  for (int m = 0; m < 3; ++m) {
    const int opposite = (m + 2) % 3;
    if (m == walker.entered || !(change[opposite] < 0)) continue;
    const double distance = std::max(0.0, -walker.place[opposite] / change[opposite]);
    if (distance < out.distance) out = {distance, m};
  }
  return out;
}

void enter_triangle(const Mesh& mesh, const MeshEdges& edges, Index next, Index edge,
                    const std::array<double, 2>& between, SurfaceWalker& walker) {
  const auto& sides = edges.of_triangle[next];
  const int entered = static_cast<int>(std::find(sides.begin(), sides.end(), edge) - sides.begin());
  const int first = entered, second = (entered + 1) % 3;
  const auto corners = corners_of(mesh, next);
  const Vector3d along = (corners[second] - corners[first]).normalized();
  const Vector3d inward = corners[(entered + 2) % 3] - corners[first];
  const double straight = std::clamp(walker.direction.dot(along), -1.0, 1.0);
  walker.direction = straight * along + std::sqrt(1 - straight * straight) *
                                            (inward - inward.dot(along) * along).normalized();
  const bool ascending = mesh.triangles[next][first] < mesh.triangles[next][second];
  const double share = between[ascending ? 1 : 0];
  walker.place.setZero();
  walker.place[second] = share;
  walker.place[first] = 1 - share;
  walker.triangle = next;
  walker.entered = entered;
}

bool SurfaceWays::go_over(SurfaceWalker& walker, int edge) const {
  const Index next = edges_.beyond(walker.triangle, edge);
  if (next == kNoTriangle) return false;
  const auto between = weights_on(walker, mesh_.triangles[walker.triangle], edge);
  enter_triangle(mesh_, edges_, next, edges_.of_triangle[walker.triangle][edge], between, walker);
  return true;
}

TrianglePoint SurfaceWays::straight_on(const TrianglePoint& from, const Vector3d& way) const {
  double left = way.norm();
  if (!(left > 0)) return from;
  SurfaceWalker walker{from.triangle, vector_of(from.barycentric), way / left};
  for (int passed = 0; passed < kMostPassed; ++passed) {
    const auto corners = corners_of(mesh_, walker.triangle);
    if (!(normal_of(corners).squaredNorm() > 0)) break;
    const Vector3d change = change_along(corners, walker.direction);
    const WayOut out = way_out(walker, change);
    walker.place += std::min(left, out.distance) * change;
    left -= out.distance;
    if (!(left > 0) || !go_over(walker, out.edge)) break;
  }
  return inside(walker.triangle, walker.place);
}

bool SurfaceWays::connect(const TrianglePoint& from, const TrianglePoint& to,
                          const Vector3d& upward, std::vector<Piece>& pieces) const {
  const std::size_t before = pieces.size();
  const Vector3d start = position_in(mesh_, from), way = position_in(mesh_, to) - start;
  const CuttingPlane plane{start, way, way.cross(upward)};
  SurfaceWalker walker{from.triangle, vector_of(from.barycentric), Vector3d::Zero()};
  for (int passed = 0; passed < kMostPassed && walker.triangle != to.triangle; ++passed) {
    const auto corners = corners_of(mesh_, walker.triangle);
    const auto out = leaving(plane, corners, walker.entered);
    // A point on an edge may belong to the triangle on either side.
    if (!out || !(std::abs(out->passed - 0.5) < 1)) break;
    const Vector3d entered = walker.place;
    walker.place.setZero();
    walker.place[out->edge] = 1 - out->share;
    walker.place[(out->edge + 1) % 3] = out->share;
    pieces.push_back({walker.triangle, array_of(entered), array_of(walker.place)});
    if (!go_over(walker, out->edge)) break;
  }
  if (walker.triangle != to.triangle) return pieces.resize(before), false;
  pieces.push_back({walker.triangle, array_of(walker.place), to.barycentric});
  return true;
}

}  // namespace brindle
