#include "brindle/pattern/end_walks.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/geometry/surface_walk.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

constexpr double kRunOnReach = 2;  // periods
constexpr double kBeyond = 1e-9;   // smaller distances, over the triangle's size, count as zero
constexpr int kMostTriangles = 4096;

Point point_of(const PieceEnd& end) {
  return {end.barycentric[0], end.barycentric[1], end.barycentric[2]};
}

/// The distance from `start` along `change` to the piece, if the ray meets it.
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

struct EndWalks::Walker : SurfaceWalker {
  double reach = 0;   ///< the largest distance
  double passed = 0;  ///< the distance so far
  bool met = false;   ///< whether it has met a curve
  std::vector<TrianglePoint> way{};

  void go(double distance, const Point& end) {
    passed += distance;
    place = end;
    way.push_back({triangle, {place[0], place[1], place[2]}});
  }
};

/// A step through one triangle.
struct EndWalks::Step {
  double distance;
  Point end;
  int edge;  // crossed at the end; -1 if the step meets a curve
};

EndWalks::EndWalks(const LiftedWaves& waves) : waves_(waves) {}

EndWalks::Step EndWalks::next_step(const Walker& walker) const {
  const std::array<Point, 3> corners = corners_of(waves_.pattern().mesh, walker.triangle);
  const Point change = change_along(corners, walker.direction);
  const WayOut out = way_out(walker, change);
  Step step{out.distance, Point::Zero(), out.edge};
  // The walk starts at the end of a piece, which must not count as met.
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

/// Enters the next triangle; false if there is none here, or it has no wave.
bool EndWalks::cross_edge(Walker& walker, int edge) const {
  const MeshEdges& edges = waves_.pattern().edges;
  const Index t = walker.triangle;
  const Index crossed = edges.of_triangle[t][edge];
  const Triangle& triangle = waves_.pattern().mesh.triangles[t];
  std::array<double, 2> between = {walker.place[edge], walker.place[(edge + 1) % 3]};
  if (triangle[edge] > triangle[(edge + 1) % 3]) std::swap(between[0], between[1]);
  const Index next = edges.beyond(t, edge);
  if (next == kNoTriangle) return false;
  enter_triangle(waves_.pattern().mesh, edges, next, crossed, between, walker);
  return waves_.triangle(next).kind != TriangleKind::no_wave;
}

/// Walks until it meets a curve, reaches its limit or cannot continue.
void EndWalks::walk(Walker& walker) const {
  for (int triangles = 0; triangles < kMostTriangles; ++triangles) {
    const Step step = next_step(walker);
    if (!(walker.passed + step.distance <= walker.reach)) return;
    walker.go(step.distance, step.end);
    walker.met = step.edge < 0;
    if (walker.met || !cross_edge(walker, step.edge)) return;
  }
}

std::optional<std::vector<TrianglePoint>> EndWalks::way_on(
    std::size_t t, const StripePiece& piece, std::span<const StripePiece> pieces) const {
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
  std::optional<Walker> shorter;
  for (const double side : {1.0, -1.0}) {
    const Point direction = (forward + side * aside).normalized();
    Walker walker{{static_cast<Index>(t), end, direction}};
    walker.reach = kRunOnReach / static_cast<double>(wave.frequency);
    walk(walker);
    if (walker.met && (!shorter || walker.passed <= shorter->passed)) shorter = std::move(walker);
  }
  if (!shorter) return std::nullopt;
  return std::move(shorter->way);
}

}  // namespace brindle
