#include "window/picture/camera_motion.h"

#include <gtest/gtest.h>

#include "brindle/shapes.h"
#include "session/picking.h"

namespace brindle::tool {
namespace {

constexpr PictureSize kSize{400, 300};

Camera camera_of(const CameraView& view) {
  static const std::vector<Vec3> points = points_of_triangles(make_shape("molecule"));
  return framed_camera(points, view, kSize.width, kSize.height);
}

std::vector<CameraView> views_of_all_kinds() {
  std::vector<CameraView> views;
  for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z, UpAxis::minus_y}) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      for (const float azimuth : {-170.0f, -30.0f, 0.0f, 75.0f}) {
        CameraView view{.azimuth_deg = azimuth, .elevation_deg = azimuth / 3, .zoom = 1.5f};
        view.up = up;
        view.projection = projection;
        views.push_back(view);
      }
    }
  }
  return views;
}

TEST(CameraMotionTest, ALightFollowsTheMouseOverItsBall) {
  const LightDirection light{170, 80};
  EXPECT_EQ(moved_light(light, {0, 0}), light);
  EXPECT_NEAR(moved_light(light, {0.1f, 0}).azimuth_deg, -166, 1e-3f) << "round the back";
  EXPECT_LT(moved_light(light, {0, 0.1f}).elevation_deg, 80) << "the mouse goes down";
  EXPECT_EQ(moved_light(light, {0, -0.5f}).elevation_deg, 90) << "not over the pole";
}

TEST(CameraMotionTest, AFreedViewShowsTheSame) {
  for (const CameraView& view : views_of_all_kinds()) {
    const Camera before = camera_of(view);
    const Camera after = camera_of(freed(view));
    EXPECT_TRUE(after.view_from_world.isApprox(before.view_from_world, 1e-4f));
    EXPECT_TRUE(after.clip_from_view.isApprox(before.clip_from_view, 1e-4f));
  }
}

TEST(CameraMotionTest, UprightUndoesFreed) {
  for (const CameraView& view : views_of_all_kinds()) {
    const CameraView back = upright(freed(view));
    EXPECT_FALSE(back.rotation.has_value());
    EXPECT_NEAR(back.azimuth_deg, view.azimuth_deg, 1e-2);
    EXPECT_NEAR(back.elevation_deg, view.elevation_deg, 1e-2);
    EXPECT_EQ(back.zoom, view.zoom);
  }
}

TEST(CameraMotionTest, BothWaysOfTurningFollowTheMouseToTheSameSide) {
  for (const CameraView& view : views_of_all_kinds()) {
    CameraView level = view;
    level.elevation_deg = 0;
    for (const Eigen::Vector2f& motion :
         {Eigen::Vector2f(0.02f, 0), Eigen::Vector2f(0, 0.02f), Eigen::Vector2f(-0.03f, 0)}) {
      const Camera turntable = camera_of(turned(level, motion));
      const Camera free = camera_of(turned(freed(level), motion));
      EXPECT_TRUE(free.view_from_world.isApprox(turntable.view_from_world, 1e-3f));
    }
  }
}

TEST(CameraMotionTest, APlaceUnderAPixelIsSeenThereAsFarAwayAsBefore) {
  const Vec3 near(0.3f, -0.2f, 0.4f);
  for (const CameraView& view : views_of_all_kinds()) {
    const Camera camera = camera_of(view);
    const auto depth = [&](const Vec3& p) {
      return (camera.view_from_world * (p - camera.origin).homogeneous()).z();
    };
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(30, 250), Eigen::Vector2d(333.5, 12)}) {
      const Vec3 place = place_under(camera, kSize, pixel, near);
      EXPECT_NEAR(depth(place), depth(near), 1e-4f);
      const auto seen = place_in_picture(place, camera, kSize.width, kSize.height);
      ASSERT_TRUE(seen);
      EXPECT_LT((*seen - pixel).norm(), 0.02);
    }
  }
}

TEST(CameraMotionTest, TurntablesStopAtThePoles) {
  CameraView view;
  for (int i = 0; i < 50; ++i) view = turned(view, {0.1f, 0.1f});
  EXPECT_EQ(view.elevation_deg, 90);
  EXPECT_LE(std::abs(view.azimuth_deg), 180);
}

TEST(CameraMotionTest, ZoomStaysWithinWhatViewsAllow) {
  EXPECT_EQ(zoomed({}, 1e6f).zoom, 10000);
  EXPECT_EQ(zoomed({}, -1e6f).zoom, 0.01f);
  EXPECT_NEAR(zoomed(zoomed({}, 5), -5).zoom, 1, 1e-5);
}

TEST(CameraMotionTest, WhatIsMovedMovesByThatManyPixels) {
  for (const CameraView& view : views_of_all_kinds()) {
    const Camera camera = camera_of(view);
    const Vec3 middle = middle_of(camera, Vec3(0.1f, 0.2f, -0.1f));
    const auto before = place_in_picture(middle, camera, kSize.width, kSize.height);
    ASSERT_TRUE(before.has_value());
    EXPECT_NEAR(before->x(), 200, 0.1);
    EXPECT_NEAR(before->y(), 150, 0.1);
    const CameraView moved_view = moved(view, camera, middle, kSize, {40, -25});
    const auto after = place_in_picture(middle, camera_of(moved_view), kSize.width, kSize.height);
    ASSERT_TRUE(after.has_value());
    EXPECT_NEAR(after->x(), 240, 1);
    EXPECT_NEAR(after->y(), 125, 1);
  }
}

}  // namespace
}  // namespace brindle::tool
