#include "brindle/pattern/run_on.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

constexpr double kRunOnReach = 2;  // periods
constexpr double kBeyond = 1e-9;   // what is nearer than this, over the triangle's size, is here
constexpr int kMostTriangles = 4096;

std::array<Point, 3> corners_of(const Mesh& mesh, std::size_t t) {
  std::array<Point, 3> corners;
  for (int m = 0; m < 3; ++m) corners[m] = mesh.positions[mesh.triangles[t][m]].cast<double>();
  return corners;
}

/// What the barycentric coordinates change by along `direction`.
Point barycentric_change(const std::array<Point, 3>& corners, const Point& direction) {
  const Point normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  Point change;
  for (int m = 0; m < 3; ++m) {
    const Point opposite = corners[(m + 2) % 3] - corners[(m + 1) % 3];
    change[m] = normal.cross(opposite).dot(direction) / normal.squaredNorm();
  }
  return change;
}

Point point_of(const PieceEnd& end) {
  return {end.barycentric[0], end.barycentric[1], end.barycentric[2]};
}

/// How far along `change` from `start` the piece lies, if that meets it.
std::optional<double> distance_to(const StripePiece& piece, const Point& start,
                                  const Point& change) {
  const Point from = point_of(piece.ends[0]);
  const Point along = point_of(piece.ends[1]) - from;
  const double area = change[1] * along[2] - change[2] * along[1];
  if (area == 0) return {};
  const Point way = from - start;
  const double u = (way[1] * change[2] - way[2] * change[1]) / area;
  if (u < 0 || u > 1) return {};
  return (way[1] * along[2] - way[2] * along[1]) / area;
}

bool lies_on(const Point& p, const StripePiece& piece) {
  const Point from = point_of(piece.ends[0]);
  const Point along = point_of(piece.ends[1]) - from;
  const Point way = p - from;
  const double share = way.dot(along);
  return way.cross(along).norm() <= kBeyond && share >= 0 && share <= along.squaredNorm();
}

}  // namespace

struct RunOn::Walker {
  std::size_t triangle;
  Point place;       // barycentric
  Point direction;   // unit, in the triangle's plane
  double reach;      // how far it may go
  int entered = -1;  // the edge it came over
  double passed = 0;
  std::vector<TrianglePoint> way{};

  void go(double distance, const Point& end) {
    passed += distance;
    place = end;
    way.push_back({static_cast<Index>(triangle), {end[0], end[1], end[2]}});
  }
};

/// Through one triangle.
struct RunOn::Step {
  double distance = std::numeric_limits<double>::infinity();
  Point end = Point::Zero();
  int edge = -1;  // that it leaves over; none if it meets a curve
};

RunOn::RunOn(const LiftedWaves& waves)
    : waves_(waves), triangles_(triangles_of_edges(waves.pattern().edges)) {}

RunOn::Step RunOn::next_step(const Walker& walker) const {
  const std::array<Point, 3> corners = corners_of(waves_.pattern().mesh, walker.triangle);
  const Point change = barycentric_change(corners, walker.direction);
  Step step;
  for (int m = 0; m < 3; ++m) {
    const int opposite = (m + 2) % 3;
    if (m == walker.entered || !(change[opposite] < 0)) continue;
    const double distance = std::max(0.0, -walker.place[opposite] / change[opposite]);
    if (distance < step.distance) step.distance = distance, step.edge = m;
  }
  // It starts at the end of a piece, which it does not meet there.
  const double least = walker.entered < 0 ? kBeyond * (corners[1] - corners[0]).norm() : 0;
  std::vector<StripePiece> pieces;
  stripe_pieces(waves_.triangle(walker.triangle), true, pieces);
  for (const StripePiece& piece : pieces) {
    const auto distance = distance_to(piece, walker.place, change);
    if (!distance || *distance < least || *distance > step.distance) continue;
    step.distance = *distance;
    step.edge = -1;
  }
  step.end = walker.place + step.distance * change;
  return step;
}

/// Goes over to the other triangle; false if there is none, or no wave on it.
bool RunOn::cross_edge(Walker& walker, int edge) const {
  const Mesh& mesh = waves_.pattern().mesh;
  const MeshEdges& edges = waves_.pattern().edges;
  const std::size_t t = walker.triangle;
  const Index crossed = edges.of_triangle[t][edge];
  if (edges.triangle_counts[crossed] != 2) return false;
  const std::size_t next = triangles_[crossed][1 - edges.ranks[t][edge]];
  const auto& sides = edges.of_triangle[next];
  const int entered =
      static_cast<int>(std::find(sides.begin(), sides.end(), crossed) - sides.begin());
  const std::array<Point, 3> corners = corners_of(mesh, next);
  const Point along = (corners[(entered + 1) % 3] - corners[entered]).normalized();
  const Point inward = corners[(entered + 2) % 3] - corners[entered];
  const double straight = std::clamp(walker.direction.dot(along), -1.0, 1.0);
  walker.direction = straight * along + std::sqrt(1 - straight * straight) *
                                            (inward - inward.dot(along) * along).normalized();
  const bool same = mesh.triangles[next][entered] == mesh.triangles[t][edge];
  const double share = walker.place[same ? (edge + 1) % 3 : edge];
  walker.place.setZero();
  walker.place[(entered + 1) % 3] = share;
  walker.place[entered] = 1 - share;
  walker.triangle = next;
  walker.entered = entered;
  return waves_.triangle(next).kind != TriangleKind::no_wave;
}

/// Whether it meets a curve.
bool RunOn::walk(Walker& walker) const {
  for (int triangles = 0; triangles < kMostTriangles; ++triangles) {
    const Step step = next_step(walker);
    if (!(walker.passed + step.distance <= walker.reach)) return false;
    walker.go(step.distance, step.end);
    if (step.edge < 0) return true;
    if (!cross_edge(walker, step.edge)) return false;
  }
  return false;
}

std::optional<std::vector<TrianglePoint>> RunOn::way(std::size_t t, const StripePiece& piece,
                                                     std::span<const StripePiece> pieces) const {
  const Point end = point_of(piece.ends[1]);
  const bool met = std::any_of(pieces.begin(), pieces.end(), [&](const StripePiece& other) {
    return &other != &piece && other.ends[1].side != PieceEnd::kInside && lies_on(end, other);
  });
  if (met) return std::vector<TrianglePoint>();

  const Mesh& mesh = waves_.pattern().mesh;
  const std::array<Point, 3> corners = corners_of(mesh, t);
  const Wave& wave = waves_.wave(mesh.triangles[t][0]).wave;
  const Point normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
  const Point across = normal.cross(wave.direction.cast<double>()).stableNormalized();
  const Point aside = across.cross(normal);
  const Point came_along = end - point_of(piece.ends[0]);
  Point came = Point::Zero();
  for (int m = 0; m < 3; ++m) came += came_along[m] * corners[m];
  const Point forward = came.dot(across) < 0 ? Point(-across) : across;
  std::optional<std::vector<TrianglePoint>> shortest;
  double reach = kRunOnReach / static_cast<double>(wave.frequency);
  for (const double side : {1.0, -1.0}) {
    Walker walker{t, end, (forward + side * aside).normalized(), reach};
    if (!walk(walker)) continue;
    reach = walker.passed;
    shortest = std::move(walker.way);
  }
  return shortest;
}

}  // namespace brindle
