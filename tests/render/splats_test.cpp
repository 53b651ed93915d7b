#include "brindle/splats.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

using test::plain_options;
using test::plane_wave;
using test::square;
using test::StripedSurface;
using test::Studio;

struct Points {
  StripedSurface surface;
  std::vector<Vec3> normals;
  std::vector<float> radii;

  explicit Points(StripedSurface of)
      : surface(std::move(of)),
        normals(surface.mesh.vertex_count(), Vec3::UnitZ()),
        radii(splat_radii(surface.mesh.positions, vertex_neighborhood(surface.mesh))) {}

  SplatDrawing drawing() const {
    return {surface.mesh.positions, normals, radii, &surface.waves, surface.z};
  }
};

Image draw(const SplatDrawing& drawing, const RenderOptions& options = plain_options()) {
  const HeadlessContext& context = Studio::shared().context;
  SplatRenderer renderer;
  renderer.upload(drawing);
  Image image = renderer.draw(options);
  context.check_errors("drawing the test picture");
  return image;
}

/// The mean difference of the red levels, of 255, over pixels that both cover; and how many do.
std::pair<double, int> difference(const Image& a, const Image& b) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (a.pixels[i].alpha < 255 || b.pixels[i].alpha < 255) continue;
    sum += std::abs(a.pixels[i].red - b.pixels[i].red);
    ++count;
  }
  return {sum / count, count};
}

struct Splats : testing::Test {
  void SetUp() override {
    try {
      Studio::shared().context.check_errors("");
    } catch (const Error&) {  // what tests of broken shaders left
    }
  }
};

TEST_F(Splats, LookLikeTheSurfaceOfTheirPoints) {
  const Points points(plane_wave(square(40), Vec3(0.8f, 0.6f, 0), 6));
  const Image mesh = Studio::shared().draw(points.surface.drawing(), plain_options());
  const auto [mean, count] = difference(draw(points.drawing()), mesh);
  EXPECT_GT(count, 160 * 120 / 3);
  EXPECT_LT(mean, 4);
}

TEST_F(Splats, LeaveNoHolesInAClosedSurface) {
  const Points points(plane_wave(square(30), Vec3::UnitX(), 6));
  const Image mesh = Studio::shared().draw(points.surface.drawing(), plain_options());
  const Image image = draw(points.drawing());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_TRUE(mesh.pixels[i].alpha < 255 || image.pixels[i].alpha > 0) << i;
  }
}

TEST_F(Splats, DoNotChangeWithTheSignsOfDirectionsAndNormals) {
  Points points(plane_wave(square(20), Vec3(0.8f, 0.6f, 0), 6));
  const Image before = draw(points.drawing());
  points.surface = with_flips(points.surface);
  std::mt19937 random(1);
  for (Vec3& normal : points.normals) {
    if (random() % 2) normal = -normal;
  }
  EXPECT_LT(difference(draw(points.drawing()), before).first, 0.5);
}

TEST_F(Splats, HideWhatLiesBehind) {
  StripedSurface front = plane_wave(square(20), Vec3::UnitX(), 6);
  // The same points again, further away and half a period on.
  const std::size_t count = front.z.size();
  for (std::size_t i = 0; i < count; ++i) {
    front.mesh.positions.push_back(front.mesh.positions[i] - Vec3(0, 0, 0.4f));
    front.waves.directions.push_back(front.waves.directions[i]);
    front.waves.frequencies.push_back(front.waves.frequencies[i]);
    front.z.push_back(-front.z[i]);
  }
  for (std::size_t t = front.mesh.triangle_count(); t-- > 0;) {
    Triangle behind = front.mesh.triangles[t];
    for (Index& vertex : behind) vertex += static_cast<Index>(count);
    front.mesh.triangles.push_back(behind);
  }
  front.waves.positions = front.mesh.positions;
  const Image mesh = Studio::shared().draw(front.drawing(), plain_options());
  EXPECT_LT(difference(draw(Points(front).drawing()), mesh).first, 8);
}

TEST_F(Splats, AreTheSameInTilesAndAtOnce) {
  const Points points(plane_wave(square(20), Vec3(0.8f, 0.6f, 0), 6));
  RenderOptions options = plain_options(200, 150);
  const Image whole = draw(points.drawing(), options);
  options.tile_side = 64;
  EXPECT_LT(difference(draw(points.drawing(), options), whole).first, 0.2);
}

TEST_F(Splats, WithoutAWaveArePlainAndWithoutANormalAreNot) {
  Points points(plane_wave(square(20), Vec3::UnitX(), 6));
  for (Vec3& direction : points.surface.waves.directions) direction.setZero();
  const Image plain = draw(points.drawing());
  int covered = 0;
  for (const Pixel& pixel : plain.pixels) {
    if (pixel.alpha < 255) continue;
    EXPECT_LE(pixel.red, 1);
    ++covered;
  }
  EXPECT_GT(covered, 160 * 120 / 3);
  for (Vec3& normal : points.normals) normal.setZero();
  for (const Pixel& pixel : draw(points.drawing()).pixels) EXPECT_EQ(pixel.alpha, 0);
}

TEST_F(Splats, RefuseSizesThatDoNotMatch) {
  Points points(plane_wave(square(4), Vec3::UnitX(), 6));
  SplatRenderer renderer;
  points.radii.pop_back();
  EXPECT_THROW(renderer.upload(points.drawing()), Error);
}

}  // namespace
}  // namespace brindle
