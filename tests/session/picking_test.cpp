#include "session/picking.h"

#include <random>

#include <gtest/gtest.h>

#include "brindle/shapes.h"

namespace brindle::tool {
namespace {

Surface square() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.origin = {100, 0, 0};
  return make_surface(mesh);
}

CameraView view_of(Projection projection, float azimuth, float elevation) {
  CameraView view{azimuth, elevation};
  view.projection = projection;
  return view;
}

TEST(Picking, FindsThePlaceUnderThePixel) {
  const Surface surface = square();
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const Camera camera =
        framed_camera(surface.mesh.positions, view_of(projection, 25, 35), 300, 200);
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.5f, -0.3f, 0), Vec3(-0.9f, 0.9f, 0)}) {
      const auto place = place_in_picture(p, camera, 300, 200);
      ASSERT_TRUE(place);
      const auto hit = pick(surface, camera, 300, 200, place->x(), place->y());
      ASSERT_TRUE(hit);
      EXPECT_LT((hit->position - p).norm(), 1e-4f);
      EXPECT_LT((hit->place - (p.cast<double>() + surface.mesh.origin)).norm(), 1e-4);
      EXPECT_TRUE(hit->normal.isApprox(Vec3::UnitZ(), 1e-5f)) << "towards the viewer";
    }
    EXPECT_FALSE(pick(surface, camera, 300, 200, 1, 1));
  }
}

TEST(Picking, FromBehindTheNormalIsThatOfTheOtherSide) {
  const Surface surface = square();
  const Camera camera =
      framed_camera(surface.mesh.positions, view_of(Projection::perspective, 180, 0), 100, 100);
  const auto hit = pick(surface, camera, 100, 100, 50, 50);
  ASSERT_TRUE(hit);
  EXPECT_TRUE(hit->normal.isApprox(Vec3(0, 0, -1), 1e-5f));
}

TEST(Picking, GoesThroughWhatASliceTakesAway) {
  const Surface ball = make_surface(make_shape("sphere,resolution=12"));
  CameraView view = view_of(Projection::perspective, 0, 0);
  const auto depth_of = [&](std::optional<Slice> slice) {
    view.slice = slice;
    const Camera camera = framed_camera(ball.mesh.positions, view, 100, 100);
    const auto hit = pick(ball, camera, 100, 100, 50, 50);
    return hit ? hit->position.z() : 5;
  };
  EXPECT_NEAR(depth_of({}), 1, 0.05);
  EXPECT_NEAR(depth_of(Slice{{0, 0, 0}, {0, 0, 1}}), -1, 0.05);
  EXPECT_EQ(depth_of(Slice{{0, 0, -2}, {0, 0, 1}}), 5) << "nothing is left";
}

/// Of a closed surface no ray that goes through the middle comes out between triangles.
TEST(Picking, MissesNothingBetweenTriangles) {
  Mesh mesh = make_shape("sphere,resolution=12");
  const Surface surface = make_surface(mesh);
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const Camera camera =
        framed_camera(points_of_triangles(mesh), view_of(projection, 13, 7), 200, 200);
    const auto expect_hit = [&](const Vec3& p) {
      const auto place = place_in_picture(p, camera, 200, 200);
      ASSERT_TRUE(place);
      EXPECT_TRUE(pick(surface, camera, 200, 200, place->x(), place->y()));
    };
    for (std::size_t t = 0; t < mesh.triangle_count(); t += 5) {
      const Triangle& triangle = mesh.triangles[t];
      const Vec3& a = mesh.positions[triangle[0]];
      const Vec3& b = mesh.positions[triangle[1]];
      expect_hit(0.9f * a);  // through corners, or just beside them
      expect_hit(0.9f * (0.37f * a + 0.63f * b));
    }
    std::mt19937 random(1);
    std::uniform_real_distribution<double> near_middle(60, 140);
    for (int i = 0; i < 300; ++i) {
      EXPECT_TRUE(pick(surface, camera, 200, 200, near_middle(random), near_middle(random)));
    }
  }
}

TEST(Picking, PointsHaveNothingToPick) {
  Surface points;
  points.mesh.positions = {{0, 0, 0}};
  EXPECT_FALSE(pick(points, framed_camera(points.mesh.positions, {}, 10, 10), 10, 10, 5, 5));
}

}  // namespace
}  // namespace brindle::tool
