#include "brindle/geometry/surface_walk.h"

#include <vector>

#include <gtest/gtest.h>

#include "brindle/shapes.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

using Eigen::Vector3d;

/// Two triangles with the edge from (0, 0, 0) to (0, 1, 0), folded by a right angle there.
struct Fold {
  Surface surface =
      make_surface({{{0, 0, 0}, {0, 1, 0}, {-1, 0.5f, 0}, {0, 0.5f, 1}}, {{0, 1, 2}, {1, 0, 3}}});
  MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  SurfaceWays ways{surface.mesh, edges};
  /// At (-0.25, 0.5, 0).
  TrianglePoint place{0, {0.375, 0.375, 0.25}};
};

TEST(SurfaceWays, GoStraightOnOverAFold) {
  const Fold fold;
  const TrianglePoint there = fold.ways.straight_on(fold.place, Vector3d(0.75, 0.1, 0));
  EXPECT_EQ(there.triangle, 1u);
  const Vector3d position = position_in(fold.surface.mesh, there);
  EXPECT_LT((position - Vector3d(0, 0.6, 0.5)).norm(), 1e-12);
}

TEST(SurfaceWays, StopAtABoundary) {
  const Fold fold;
  const TrianglePoint there = fold.ways.straight_on(fold.place, Vector3d(9, 0, 0));
  EXPECT_LT((position_in(fold.surface.mesh, there) - Vector3d(0, 0.5, 1)).norm(), 1e-12);
  const TrianglePoint stays = fold.ways.straight_on(fold.place, Vector3d::Zero());
  EXPECT_EQ(stays.barycentric, fold.place.barycentric);
}

TEST(SurfaceWays, ComeBackOnTheSameWay) {
  const Surface surface = make_surface(make_shape("trefoil,resolution=30"));
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  const SurfaceWays ways(surface.mesh, edges);
  const float size = bounding_box(surface.mesh).diagonal();
  for (Index t = 0; t < surface.mesh.triangle_count(); t += 7) {
    const TrianglePoint start{t, {0.3, 0.3, 0.4}};
    const auto corners = corners_of(surface.mesh, t);
    const Vector3d way = 0.05 * static_cast<double>(size) * (corners[1] - corners[0]).normalized();
    const TrianglePoint end = ways.straight_on(start, way);
    std::vector<SurfaceWays::Piece> pieces;
    ASSERT_TRUE(ways.connect(start, end, normal_of(corners).normalized(), pieces)) << t;
    EXPECT_EQ(pieces.front().triangle, start.triangle);
    EXPECT_EQ(pieces.back().triangle, end.triangle);
    double length = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Vector3d from = position_in(surface.mesh, {pieces[i].triangle, pieces[i].from});
      const Vector3d to = position_in(surface.mesh, {pieces[i].triangle, pieces[i].to});
      length += (to - from).norm();
      if (i == 0) continue;
      const Vector3d before = position_in(surface.mesh, {pieces[i - 1].triangle, pieces[i - 1].to});
      EXPECT_LT((from - before).norm(), 1e-6 * static_cast<double>(size));
    }
    const double chord = (position_in(surface.mesh, end) - position_in(surface.mesh, start)).norm();
    EXPECT_GE(length, chord * (1 - 1e-9));
    EXPECT_LE(length, 1.1 * way.norm()) << t;
  }
}

}  // namespace
}  // namespace brindle
