#include "brindle/feature_lines.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

using namespace test;

const Vec3 kEye(4, 1, 2);

TEST(FeatureLines, TheSilhouetteOfASphereIsOneCircle) {
  const Surface sphere = make_surface(make_shape("sphere,resolution=20"));
  const Polylines lines = silhouette_lines(sphere.mesh, sphere.normals, kEye);
  ASSERT_EQ(lines.count(), 1u);
  EXPECT_EQ(lines.closed[0], 1);
  // A sphere of radius 1 seen from the distance D has it where p eye = 1.
  for (const Vec3& p : lines.points) EXPECT_NEAR(p.dot(kEye), 1, 0.02f);
  const double radius = std::sqrt(1 - 1 / kEye.squaredNorm());
  EXPECT_NEAR(length_of(lines, 0), 2 * std::numbers::pi * radius, 0.02);
}

TEST(FeatureLines, SilhouettesDoNotDependOnWhichSideNormalsPointTo) {
  const Surface torus = make_surface(make_shape("torus,resolution=40"));
  std::vector<Vec3> turned = torus.normals;
  for (Vec3& normal : turned) normal = -normal;
  EXPECT_EQ(silhouette_lines(torus.mesh, torus.normals, kEye).points.size(),
            silhouette_lines(torus.mesh, turned, kEye).points.size());
}

/// Its tube is seen from above, edge on nowhere but at two places.
TEST(FeatureLines, SilhouettesPassTheSeamOfASurfaceWithOneSide) {
  const Surface strip = make_surface(make_shape("mobius,resolution=40"));
  const auto turned_apart = [&](const Triangle& t) {
    const auto against = [&](Index a, Index b) {
      return strip.normals[a].dot(strip.normals[b]) < 0;
    };
    return against(t[0], t[1]) || against(t[1], t[2]);
  };
  const auto seam = std::ranges::count_if(strip.mesh.triangles, turned_apart);
  ASSERT_GT(seam, 3) << "nothing is shown where normals are turned nowhere";
  std::size_t on_seam = 0;
  const Polylines lines = silhouette_lines(strip.mesh, strip.normals, kEye);
  for (const TrianglePoint& place : lines.places) {
    on_seam += turned_apart(strip.mesh.triangles[place.triangle]);
  }
  EXPECT_LT(on_seam, static_cast<std::size_t>(seam) / 3);
}

TEST(FeatureLines, CreasesAreBordersAndSharpEdges) {
  Mesh fold = square(4);
  for (Vec3& p : fold.positions) p.z() = std::abs(p.x() - 0.5f);  // by 90 degrees
  const Surface surface = make_surface(fold);
  const auto length = [&](float degrees) {
    const Polylines lines = crease_lines(surface.mesh, surface.normals, degrees);
    double sum = 0;
    for (std::size_t line = 0; line < lines.count(); ++line) sum += length_of(lines, line);
    return sum;
  };
  const double border = 2 + 2 * std::sqrt(2.0);
  EXPECT_NEAR(length(91), border, 1e-5);
  EXPECT_NEAR(length(89), border + 1, 1e-5);
}

TEST(FeatureLines, DashesLieWhereThePatternHasStrokes) {
  StripedSurface s = plane_wave(square(8), Vec3::UnitX(), 5);
  const Surface surface = make_surface(s.mesh);
  const Polylines border = crease_lines(surface.mesh, surface.normals, 45);
  const Polylines dashes = dashes_of(border, s.mesh, s.waves, s.z, 0.3f);
  double along = 0;
  for (std::size_t line = 0; line < dashes.count(); ++line) {
    for (const Vec3& p : dashes.points_of(line)) {
      const float turns = 5 * p.x() - 0.25f;
      EXPECT_LE(std::abs(turns - std::round(turns)), 0.15f + 1e-3f);
    }
    const Vec3 way = dashes.points_of(line).back() - dashes.points_of(line).front();
    along += static_cast<double>(std::abs(way.x()));
  }
  EXPECT_NEAR(along, 2 * 0.3, 0.05);
  EXPECT_NEAR(length_of(dashes_of(border, s.mesh, s.waves, s.z, 1), 0), 4, 1e-3);
}

TEST(FeatureLines, WithoutWavesLinesAreWhole) {
  StripedSurface s = plane_wave(square(4), Vec3::UnitX(), 5);
  for (Vec3& direction : s.waves.directions) direction = Vec3::Zero();
  const Surface surface = make_surface(s.mesh);
  const Polylines border = crease_lines(surface.mesh, surface.normals, 45);
  const Polylines dashes = dashes_of(border, s.mesh, s.waves, s.z, 0.3f);
  ASSERT_EQ(dashes.count(), 1u);
  EXPECT_NEAR(length_of(dashes, 0), 4, 0.02);
}

TEST(FeatureLines, DashesOfStrokesHaveTheLengthsThatAreAskedFor) {
  const std::vector<Stroke> strokes{{{0, 0}, {3, 0}, {23, 0}}};
  const std::vector<Stroke> cut = dashed(strokes, 4, 2);
  ASSERT_EQ(cut.size(), 4u);
  for (std::size_t i = 0; i < cut.size(); ++i) {
    EXPECT_NEAR(cut[i].front().x(), 6 * static_cast<float>(i), 1e-4f);
    EXPECT_NEAR(cut[i].back().x() - cut[i].front().x(), 4, 1e-4f);
  }
  EXPECT_THROW(dashed(strokes, 0, 1), Error);
}

TEST(FeatureLines, HiddenAndVisiblePartsMakeTheWhole) {
  const Surface torus = make_surface(make_shape("torus,resolution=60"));
  const CameraView view{.azimuth_deg = 30, .elevation_deg = 20, .up = UpAxis::z};
  const Camera camera = framed_camera(points_of_triangles(torus.mesh), view, 300, 200);
  const Visibility visibility(torus.mesh, camera, 300, 200);
  const Eigen::Matrix3f axes = camera.view_from_world.topLeftCorner<3, 3>();
  const Vec3 eye = camera.origin - axes.transpose() * camera.view_from_world.topRightCorner<3, 1>();
  const Polylines lines = silhouette_lines(torus.mesh, torus.normals, eye);
  const auto length = [](const std::vector<Stroke>& strokes) {
    float sum = 0;
    for (const Stroke& stroke : strokes) {
      for (std::size_t i = 1; i < stroke.size(); ++i) sum += (stroke[i] - stroke[i - 1]).norm();
    }
    return sum;
  };
  const float seen = length(visibility.strokes(lines, 0.008f));
  const float hidden = length(visibility.strokes(lines, 0.008f, true));
  const float all = length(Visibility(Mesh(), camera, 300, 200).strokes(lines, 0.008f));
  EXPECT_GT(hidden, 0.02f * all);
  EXPECT_GT(seen, 0.5f * all);
  EXPECT_NEAR(seen + hidden, all, 0.03f * all);
}

TEST(FeatureLines, NormalsMustFit) {
  const Mesh mesh = square(2);
  EXPECT_THROW(silhouette_lines(mesh, {}, kEye), Error);
}

}  // namespace
}  // namespace brindle
