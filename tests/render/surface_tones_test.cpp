#include "brindle/surface_tones.h"

#include <limits>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/styled_picture.h"
#include "brindle/surface.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

constexpr int kTonesWidth = 320, kTonesHeight = 240;

struct Seen {
  std::size_t vertices = 0;
  double worst = 0;
};

/// The tones of vertices against those of the pixels that show them.
Seen compare(const Surface& surface, const PictureLight& light) {
  StyledOptions options;
  options.render.width = kTonesWidth;
  options.render.height = kTonesHeight;
  options.render.camera.up = light.up;
  options.render.light_from = light.from;
  options.render.transparent = true;
  const std::vector<StyledSurface> surfaces{
      {.mesh = surface.mesh, .normals = surface.normals, .color = {1, 1, 1}}};
  const Image image = render_styled(surfaces, options);
  const Camera camera = styled_camera(surfaces, options);
  const std::vector<float> tones = surface_tones(surface.mesh, surface.normals, camera, light);
  const Vec3 eye = eye_of(camera);
  Seen seen;
  for (std::size_t v = 0; v < tones.size(); ++v) {
    const Vec3& position = surface.mesh.positions[v];
    const Vec3 to_eye = (eye - position).normalized();
    if (surface.normals[v].dot(to_eye) < 0.3f) continue;
    const Eigen::Vector4f clip =
        camera.clip_from_view *
        (camera.view_from_world * Vec3(position - camera.origin).homogeneous());
    const int x = static_cast<int>((clip.x() / clip.w() + 1) / 2 * kTonesWidth);
    const int y = static_cast<int>((1 - clip.y() / clip.w()) / 2 * kTonesHeight);
    const Pixel pixel = image.at(x, y);
    if (pixel.alpha < 255) continue;
    const Vec3 shown = premultiplied_light(pixel).head<3>();
    const float tone = std::pow(shown.dot(Vec3(0.2126f, 0.7152f, 0.0722f)), 1 / 2.2f);
    seen.worst = std::max(seen.worst, std::abs(static_cast<double>(tone - tones[v])));
    ++seen.vertices;
  }
  return seen;
}

TEST(SurfaceTones, AreThoseOfPictures) {
  for (const PictureLight& light :
       {PictureLight{UpAxis::y}, PictureLight{UpAxis::z}, PictureLight{UpAxis::y, {{75, 10}}},
        PictureLight{UpAxis::z, {{-120, -35}}}, PictureLight{UpAxis::y, {{0, 90}}}}) {
    const Seen seen = compare(make_surface(make_shape("sphere,resolution=24")), light);
    EXPECT_GT(seen.vertices, 300u);
    EXPECT_LT(seen.worst, 0.03);
  }
}

/// Of a smooth white sphere, in linear light.
Image sphere_lit_from(std::optional<LightDirection> from, float azimuth_deg = 30) {
  static const Surface sphere = make_surface(make_shape("sphere,resolution=60"));
  RenderOptions options;
  options.width = options.height = 160;
  options.camera.azimuth_deg = azimuth_deg;
  options.base_color = {1, 1, 1};
  options.transparent = true;
  options.light_from = from;
  return render_picture({.mesh = sphere.mesh, .normals = sphere.normals}, options);
}

/// The sum of all light in the columns from `begin` to `end`, or the rows.
double light_in(const Image& image, int begin, int end, bool rows = false) {
  double sum = 0;
  for (int i = begin; i < end; ++i) {
    for (int j = 0; j < 160; ++j) {
      sum += static_cast<double>(
          premultiplied_light(rows ? image.at(j, i) : image.at(i, j)).head<3>().sum());
    }
  }
  return sum;
}

TEST(PictureLight, BrightensTheSideThatItComesFrom) {
  const Image left = sphere_lit_from({{-80, 0}}), right = sphere_lit_from({{80, 0}});
  EXPECT_GT(light_in(left, 0, 80), 1.3 * light_in(left, 80, 160));
  EXPECT_GT(light_in(right, 80, 160), 1.3 * light_in(right, 0, 80));
  // The same from the other side, as in a mirror.
  EXPECT_NEAR(light_in(left, 0, 80) / light_in(right, 80, 160), 1, 0.02);
  EXPECT_NEAR(light_in(left, 80, 160) / light_in(right, 0, 80), 1, 0.02);
  const Image above = sphere_lit_from({{0, 80}}), below = sphere_lit_from({{0, -80}});
  EXPECT_GT(light_in(above, 0, 80, true), 1.3 * light_in(above, 80, 160, true));
  EXPECT_LT(light_in(below, 0, 80, true), light_in(below, 80, 160, true));
}

TEST(PictureLight, GoesWithTheCamera) {
  const Image one = sphere_lit_from({{50, 20}}, 0), other = sphere_lit_from({{50, 20}}, 90);
  int worst = 0;
  for (std::size_t p = 0; p < one.pixels.size(); ++p) {
    if (one.pixels[p].alpha < 255 || other.pixels[p].alpha < 255) continue;
    worst = std::max(worst, std::abs(one.pixels[p].red - other.pixels[p].red));
  }
  EXPECT_LE(worst, 6) << "facets alone";
}

// What counts without a direction is one of them, less rounding.
TEST(PictureLight, UsuallyComesFromTheUpperLeft) {
  const Image usual = sphere_lit_from({});
  const Image given = sphere_lit_from({{-30.963757f, 38.673f}});
  int worst = 0;
  for (std::size_t p = 0; p < usual.pixels.size(); ++p) {
    worst = std::max(worst, std::abs(usual.pixels[p].red - given.pixels[p].red));
  }
  EXPECT_LE(worst, 1);
}

TEST(PictureLight, IsRefusedFromNowhere) {
  EXPECT_THROW(sphere_lit_from({{std::numeric_limits<float>::quiet_NaN(), 0}}), Error);
}

TEST(SurfaceTones, AreThoseOfTheOuterSide) {
  Mesh mesh = make_shape("sphere,resolution=12");
  const Surface outside = make_surface(mesh);
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  const Surface inside_out = make_surface(mesh);
  const Camera camera = framed_camera(mesh.positions, {}, kTonesWidth, kTonesHeight);
  const auto one = surface_tones(outside.mesh, outside.normals, camera, {UpAxis::y});
  const auto other = surface_tones(inside_out.mesh, inside_out.normals, camera, {UpAxis::y});
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t v = 0; v < one.size(); ++v) EXPECT_NEAR(one[v], other[v], 1e-4);
  EXPECT_GT(*std::ranges::max_element(one), 0.8f);
  EXPECT_LT(*std::ranges::min_element(one), 0.5f);
}

TEST(SurfaceTones, NeedNormals) {
  const Surface surface = make_surface(make_shape("plane,resolution=2"));
  std::vector<Vec3> normals = surface.normals;
  const Camera camera = framed_camera(surface.mesh.positions, {}, kTonesWidth, kTonesHeight);
  normals[1] = Vec3::Zero();
  const auto tones = surface_tones(surface.mesh, normals, camera, {UpAxis::y});
  EXPECT_TRUE(std::isnan(tones[1]));
  EXPECT_FALSE(std::isnan(tones[0]));
  normals.pop_back();
  EXPECT_THROW(surface_tones(surface.mesh, normals, camera, {UpAxis::y}), Error);
}

}  // namespace
}  // namespace brindle
