// Parallel projection, free rotations and centres, in everything that draws.
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/feature_lines.h"
#include "brindle/geometry/topology.h"
#include "brindle/headless_context.h"
#include "brindle/line_drawing.h"
#include "brindle/normals.h"
#include "brindle/shapes.h"
#include "brindle/splats.h"
#include "brindle/styled_picture.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

using test::plain_options;
using test::plane_wave;
using test::square;
using test::Studio;

CameraView straight(Projection projection) {
  CameraView view{0, 0};
  view.projection = projection;
  return view;
}

Eigen::Vector2f place_of(const Camera& camera, const Vec3& p) {
  const Eigen::Vector4f clip =
      camera.clip_from_view * camera.view_from_world * (p - camera.origin).homogeneous();
  return clip.head<2>() / clip.w();
}

Mesh turned_square(float degrees) {
  Mesh mesh = square(8);
  const Eigen::AngleAxisf turn(degrees * std::numbers::pi_v<float> / 180, Vec3::UnitY());
  for (Vec3& p : mesh.positions) p = turn * p;
  return mesh;
}

/// Pixels of a picture that are more covered than not: in its middle row and its middle column.
std::pair<int, int> extent_of(const Image& image) {
  int columns = 0, rows = 0;
  for (int x = 0; x < image.width; ++x) columns += image.at(x, image.height / 2).alpha > 127;
  for (int y = 0; y < image.height; ++y) rows += image.at(image.width / 2, y).alpha > 127;
  return {columns, rows};
}

/// The share of pixels that differ by more than a few levels.
double share_of_different(const Image& a, const Image& b) {
  int different = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    different += std::abs(a.pixels[i].red - b.pixels[i].red) > 6 ||
                 std::abs(a.pixels[i].alpha - b.pixels[i].alpha) > 6;
  }
  return static_cast<double>(different) / static_cast<double>(a.pixels.size());
}

TEST(Projection, ParallelKeepsLengthsAtAllDepths) {
  const std::vector<Vec3> points = {{-1, -1, -5}, {1, 1, -5}, {-1, -1, 5}, {1, 1, 5}};
  const Camera camera = framed_camera(points, straight(Projection::orthographic), 400, 300);
  EXPECT_TRUE(camera.orthographic());
  EXPECT_FALSE(framed_camera(points, straight(Projection::perspective), 400, 300).orthographic());
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    const Eigen::Vector2f half =
        (place_of(camera, points[i + 1]) - place_of(camera, points[i])) / 2;
    EXPECT_NEAR(half.y(), 0.95f, 1e-6f);  // fills the height up to the margin
    EXPECT_NEAR(half.x() * 400, half.y() * 300, 1e-3f);
  }
}

TEST(Projection, APictureOfAPlaneHasItsExactScale) {
  RenderOptions options = plain_options(200, 200);
  options.camera = straight(Projection::orthographic);
  options.base_color = {1, 1, 1};
  const Mesh flat = turned_square(0), turned = turned_square(60);
  EXPECT_EQ(extent_of(Studio::shared().draw({.mesh = flat}, options)), std::pair(190, 190));
  const Image image = Studio::shared().draw({.mesh = turned}, options);
  EXPECT_EQ(extent_of(image).second, 190);
  EXPECT_NEAR(extent_of(image).first, 95, 1);  // its ends are in the middle of pixels
  options.camera.zoom = 0.5f;
  EXPECT_NEAR(extent_of(Studio::shared().draw({.mesh = flat}, options)).second, 95, 1);
}

/// What faces the viewer looks the same in both projections, whatever draws it.
TEST(Projection, WhatFacesTheViewerLooksAlike) {
  const test::StripedSurface waves = plane_wave(square(30), Vec3(0.8f, 0.6f, 0), 12);
  const std::vector<Vec3> normals(waves.mesh.vertex_count(), Vec3::UnitZ());
  const std::vector<Mark> marks = {{Vec3(0.3f, 0.6f, 0), {1, 0, 0}}};
  const std::vector<float> radii =
      splat_radii(waves.mesh.positions, vertex_neighborhood(waves.mesh));
  RenderOptions options = plain_options(200, 150);
  SurfaceDrawing drawing = waves.drawing();
  drawing.normals = normals;
  drawing.marks = marks;
  StyledSurface styled{.mesh = waves.mesh, .normals = normals, .shading = false};
  styled.strokes.push_back({.waves = &waves.waves, .z = waves.z});
  std::array<std::array<Image, 3>, 2> images;
  const HeadlessContext& context = Studio::shared().context;
  for (const int i : {0, 1}) {
    options.camera = straight(i == 0 ? Projection::perspective : Projection::orthographic);
    images[i][0] = Studio::shared().draw(drawing, options);
    StyledRenderer renderer;
    renderer.upload({&styled, 1});
    StyledOptions how;
    how.render = options;
    how.occlusion = 0.7f;
    how.right_margin = 40;
    images[i][1] = renderer.draw(how);
    SplatRenderer splats;
    splats.upload({waves.mesh.positions, normals, radii, &waves.waves, waves.z});
    images[i][2] = splats.draw(options);
    context.check_errors("drawing the test pictures");
  }
  for (const int k : {0, 1, 2}) {
    EXPECT_LT(share_of_different(images[0][k], images[1][k]), 0.01) << k;
    EXPECT_GT(extent_of(images[1][k]).second, 100) << "something is seen";
  }
}

TEST(Projection, GroundShadowsLieBelowInBoth) {
  Mesh table = square(8);
  for (Vec3& p : table.positions) p = Vec3(p.x(), 0.4f, p.y());
  Mesh leg = square(1);
  for (Vec3& p : leg.positions) p = Vec3(0.5f + 0.02f * p.x(), 0.4f * p.y(), 0.5f);
  const std::vector<StyledSurface> surfaces{{.mesh = table}, {.mesh = leg}};
  const HeadlessContext context;
  StyledRenderer renderer;
  renderer.upload(surfaces);
  const auto shadow = [&](Projection projection) {
    StyledOptions options;
    options.render = plain_options(200, 150);
    options.render.camera = straight(projection);
    options.render.camera.elevation_deg = 25;
    const Image without = renderer.draw(options);
    options.ground_shadow = true;
    const Image with = renderer.draw(options);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // amount, and where its middle is
    for (int y = 0; y < with.height; ++y) {
      for (int x = 0; x < with.width; ++x) {
        const double darker = with.at(x, y).alpha - without.at(x, y).alpha;
        sum += darker * Eigen::Vector3d(1, x, y);
      }
    }
    return Eigen::Vector3d(sum[0] / 255, sum[1] / sum[0], sum[2] / sum[0]);
  };
  const Eigen::Vector3d perspective = shadow(Projection::perspective);
  const Eigen::Vector3d parallel = shadow(Projection::orthographic);
  EXPECT_GT(parallel[0], 0.6 * perspective[0]);
  EXPECT_LT(parallel[0], 1.6 * perspective[0]);
  EXPECT_LT((parallel - perspective).tail<2>().norm(), 15);
}

TEST(Projection, ATurntableIsAlsoAFreeRotation) {
  const Mesh mesh = make_shape("trefoil,resolution=24");
  const std::vector<Vec3> points = points_of_triangles(mesh);
  for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z, UpAxis::minus_y}) {
    const CameraView turntable{37, -21, 1.3f, up};
    CameraView free{0, 0, 1.3f, up};
    free.rotation = rotation_of(turntable);
    EXPECT_TRUE(rotation_of(free).isApprox(rotation_of(turntable), 1e-6f));
    const Camera a = framed_camera(points, turntable, 200, 150);
    const Camera b = framed_camera(points, free, 200, 150);
    EXPECT_TRUE(a.view_from_world.isApprox(b.view_from_world, 1e-5f));
    EXPECT_TRUE(a.clip_from_view.isApprox(b.clip_from_view, 1e-5f));
  }
}

TEST(Projection, AVisibleHeightGivesTheScale) {
  const std::vector<Vec3> points = {{-1, -1, -5}, {1, 1, -5}, {-1, -1, 5}, {1, 1, 5}};
  CameraView view = straight(Projection::orthographic);
  view.visible_height = 8;
  for (const int finer : {1, 2}) {
    const Camera camera = framed_camera(points, view, finer * 400, finer * 200);
    EXPECT_LT((place_of(camera, points[3]) - Eigen::Vector2f(0.125f, 0.25f)).norm(), 1e-6f);
  }
  view.zoom = 3;
  EXPECT_NEAR(place_of(framed_camera(points, view, 200, 200), points[3]).y(), 0.75f, 1e-6f);
  view.zoom = 1;
  view.visible_height = 1.9f;
  EXPECT_THROW(framed_camera(points, view, 400, 200), Error) << "the points are 2 high";
  view.visible_height = 2;
  EXPECT_NO_THROW(framed_camera(points, view, 400, 200));
  EXPECT_THROW(framed_camera(points, view, 199, 200), Error) << "and 2 wide";
  view.projection = Projection::perspective;
  EXPECT_THROW(framed_camera(points, view, 400, 200), Error);
}

TEST(Projection, TheCentreIsInTheMiddle) {
  const Mesh mesh = make_shape("box,resolution=5");
  const std::vector<Vec3> points = points_of_triangles(mesh);
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    CameraView view{33, 12, 5};
    view.projection = projection;
    view.center = points.front();
    EXPECT_LT(place_of(framed_camera(points, view, 200, 150), points.front()).norm(), 1e-4f);
    view.azimuth_deg = 80;  // and stays there
    EXPECT_LT(place_of(framed_camera(points, view, 200, 150), points.front()).norm(), 1e-4f);
  }
}

TEST(Projection, LinesAreHiddenByWhatIsInFrontInBoth) {
  Mesh mesh = square(1);
  for (Vec3& p : mesh.positions) p = 2 * p - Vec3(1, 1, 0);
  const std::size_t back = mesh.vertex_count();
  for (std::size_t v = 0; v < back; ++v) {
    mesh.positions.push_back(0.5f * mesh.positions[v] + Vec3(0, 0, 2));
  }
  mesh.triangles.push_back({4, 5, 6});
  mesh.triangles.push_back({5, 7, 6});
  Polylines line;
  line.points = {{-1, 0.1f, 0}, {1, 0.1f, 0}};  // on the square behind
  line.normals.assign(2, Vec3::UnitZ());
  line.offsets.push_back(2);
  line.closed.push_back(0);
  const Visibility parallel(mesh, straight(Projection::orthographic), 400, 400);
  const std::vector<Stroke> strokes = parallel.strokes(line);
  ASSERT_EQ(strokes.size(), 2u) << "the middle is hidden";
  EXPECT_NEAR(strokes[0].front().x(), 10, 1);
  EXPECT_NEAR(strokes[0].back().x(), 105, 2) << "half of it, at any distance";
}

TEST(Projection, TheSilhouetteOfASphereIsItsGreatCircle) {
  const Mesh mesh = make_shape("sphere,resolution=40");
  const std::vector<Vec3> normals = vertex_normals(mesh);
  CameraView view{20, 30};
  view.projection = Projection::orthographic;
  const Camera camera = framed_camera(points_of_triangles(mesh), view, 300, 300);
  const Vec3 towards = camera.view_from_world.row(2).head<3>();
  const Polylines lines = silhouette_lines(mesh, normals, viewpoint_of(camera));
  ASSERT_GT(lines.points.size(), 20u);
  const float radius = mesh.positions[0].norm();
  for (const Vec3& p : lines.points) EXPECT_NEAR(p.dot(towards) / radius, 0, 0.03);
}

}  // namespace
}  // namespace brindle
