#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "brindle/camera.h"
#include "render/picture_error.h"

namespace brindle {
namespace {

using namespace test;

/// What a scene's picture may be off its reference, in squares of levels of 255. That of the final
/// quality is what one pass with 2 x 2 samples a pixel, and multisampling, was off.
struct Bound {
  double interactive, final;
};

constexpr Bound kBounds[] = {{13.9, 3.99}, {80, 8.10}, {22, 20.24}, {4.6, 4.24}};

Image drawn(const HardScene& scene, PictureQuality quality) {
  RenderOptions options = scene.options;
  options.quality = quality;
  return Studio::shared().draw(scene.drawing(), options);
}

TEST(Quality, IsNearAReferenceOf64TimesTheSamples) {
  constexpr int kFactor = 8;
  const std::vector<HardScene> scenes = hard_scenes();
  ASSERT_EQ(scenes.size(), std::size(kBounds));
  std::printf("mean squared error, levels of 255     interactive     final\n");
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const HardScene& scene = scenes[k];
    RenderOptions large = scene.options;
    large.width *= kFactor;
    large.height *= kFactor;
    large.supersampling = 1;
    const Image reference = smaller(Studio::shared().draw(scene.drawing(), large), kFactor);
    const double interactive =
        mean_squared_error(drawn(scene, PictureQuality::interactive), reference);
    const double final = mean_squared_error(drawn(scene, PictureQuality::final), reference);
    std::printf("%-36s %12.2f %9.2f\n", scene.name.c_str(), interactive, final);
    EXPECT_LE(interactive, kBounds[k].interactive) << scene.name;
    EXPECT_LE(final, kBounds[k].final) << scene.name;
  }
}

TEST(Quality, OfBothKindsAgreesAwayFromEdges) {
  // Wide stripes on a curved surface; edges are where a pixel differs from its neighbours.
  const StripedSurface surface = plane_wave(saddle(12), Vec3(0.8f, 0.6f, 0), 4);
  RenderOptions options = plain_options(320, 240);
  options.shading = true;
  options.camera = {.azimuth_deg = 20, .elevation_deg = 15};
  const Image fine = Studio::shared().draw(surface.drawing(), options);
  options.quality = PictureQuality::interactive;
  const Image fast = Studio::shared().draw(surface.drawing(), options);
  int compared = 0;
  for (int y = 2; y < 238; ++y) {
    for (int x = 2; x < 318; ++x) {
      int lowest = 255, highest = 0;
      for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
          const Pixel& near = fine.at(x + i, y + j);
          lowest = std::min<int>({lowest, near.red, near.alpha});
          highest = std::max<int>({highest, near.red, 255 - near.alpha});
        }
      }
      if (highest - lowest > 12 || fine.at(x, y).alpha < 255) continue;
      ++compared;
      ASSERT_NEAR(fast.at(x, y).red, fine.at(x, y).red, 6) << x << ' ' << y;
    }
  }
  EXPECT_GT(compared, 3000);
}

TEST(Quality, DoesNotDependOnTheNumberOfTriangles) {
  // The same square in 2 triangles and in more than there are pixels.
  for (const PictureQuality quality : {PictureQuality::interactive, PictureQuality::final}) {
    RenderOptions options = plain_options(120, 90);
    options.camera = {.azimuth_deg = 15, .elevation_deg = 25};
    options.quality = quality;
    const auto picture = [&](int n) {
      StripedSurface surface = plane_wave(square(n), Vec3(0.8f, 0.6f, 0), 7);
      SurfaceDrawing drawing = surface.drawing();
      const std::vector<Vec3> normals(surface.mesh.vertex_count(), Vec3::UnitZ());
      drawing.normals = normals;
      return Studio::shared().draw(drawing, options);
    };
    const Image coarse = picture(1), fine = picture(200);
    for (std::size_t p = 0; p < coarse.pixels.size(); ++p) {
      ASSERT_NEAR(coarse.pixels[p].red, fine.pixels[p].red, 4);
      ASSERT_NEAR(coarse.pixels[p].alpha, fine.pixels[p].alpha, 1);
    }
  }
}

TEST(Quality, PicturesAreTheSameEveryTime) {
  const StripedSurface surface = random_waves(saddle(20), 15);
  for (const PictureQuality quality : {PictureQuality::interactive, PictureQuality::final}) {
    RenderOptions options = plain_options();
    options.quality = quality;
    const Image once = Studio::shared().draw(surface.drawing(), options);
    RenderOptions other = plain_options(96, 64);
    Studio::shared().renderer.draw(other);
    EXPECT_EQ(Studio::shared().renderer.draw(options).pixels, once.pixels);
    EXPECT_EQ(Studio::shared().draw(surface.drawing(), options).pixels, once.pixels);
  }
}

TEST(Quality, NoSeamsShowWhereTrianglesMeet) {
  // One colour and no light: every covered pixel is exactly that, whatever triangles it shows.
  StripedSurface surface = random_waves(saddle(60), 5);
  for (const PictureQuality quality : {PictureQuality::interactive, PictureQuality::final}) {
    RenderOptions options = plain_options(200, 150);
    options.quality = quality;
    options.stripe_width = 1;
    const Image image = Studio::shared().draw(surface.drawing(), options);
    int covered = 0;
    for (int y = 30; y < 120; ++y) {
      for (int x = 50; x < 150; ++x) {
        ASSERT_GE(image.at(x, y).red, 254) << x << ' ' << y;
        ASSERT_EQ(image.at(x, y).alpha, 255) << x << ' ' << y;
        ++covered;
      }
    }
    EXPECT_EQ(covered, 9000);
  }
}

TEST(Quality, SilhouettesAreSmoothInBothKinds) {
  const Mesh mesh = square(1);
  for (const PictureQuality quality : {PictureQuality::interactive, PictureQuality::final}) {
    RenderOptions options = plain_options(160, 120);
    options.quality = quality;
    options.supersampling = 2;
    options.camera = {.azimuth_deg = 33, .elevation_deg = 21};
    const Image image = Studio::shared().draw({.mesh = mesh}, options);
    std::array<bool, 256> levels{};
    for (const Pixel& pixel : image.pixels) levels[pixel.alpha] = true;
    EXPECT_GE(std::ranges::count(levels, true), quality == PictureQuality::final ? 12 : 4);
  }
}

TEST(Quality, PicturesOfOnePixelAndOfManyTilesAreDrawn) {
  const StripedSurface surface = plane_wave(square(3), Vec3::UnitX(), 3);
  RenderOptions options = plain_options(1, 1);
  EXPECT_GT(Studio::shared().draw(surface.drawing(), options).at(0, 0).alpha, 200);
  for (const auto& [width, height] : {std::pair{9000, 8}, std::pair{8, 9000}}) {
    RenderOptions wide = plain_options(width, height);
    const Image image = Studio::shared().draw(surface.drawing(), wide);
    EXPECT_EQ(image.at(width / 2, height / 2).alpha, 255);
    EXPECT_EQ(image.at(0, 0).alpha, 0);
    EXPECT_EQ(image.at(width - 1, height - 1).alpha, 0);
  }
}

/// The corner's place in the picture, in pixels from the upper left, and its w.
Eigen::Vector3d place_of(const Vec3& position, const Camera& camera, int width, int height) {
  const Eigen::Vector4d view = camera.view_from_world.cast<double>() *
                               (position - camera.origin).cast<double>().homogeneous();
  const Eigen::Vector4d clip = camera.clip_from_view.cast<double>() * view;
  return {(clip.x() / clip.w() + 1) / 2 * width, (1 - clip.y() / clip.w()) / 2 * height, clip.w()};
}

TEST(Quality, BarycentricCoordinatesAreThoseOfThePlaceInThePicture) {
  StripedSurface surface = plane_wave(saddle(5), Vec3::UnitX(), 3);
  RenderOptions options = plain_options(200, 150);
  options.camera = {.azimuth_deg = 35, .elevation_deg = 40};
  Studio::shared().probe.upload(surface.drawing());
  const FragmentImage image = Studio::shared().probe.draw(options);
  const Camera camera = framed_camera(surface.mesh.positions, options.camera, 200, 150);
  double largest = 0;
  int compared = 0;
  for (int p = 0; p < 200 * 150; ++p) {
    if (image.triangle[p] == FragmentImage::kNoTriangle) continue;
    const Triangle& t = surface.mesh.triangles[image.triangle[p]];
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double sum = 0;
    for (int m = 0; m < 3; ++m) {
      const Eigen::Vector3d corner = place_of(surface.mesh.positions[t[m]], camera, 200, 150);
      const double weight = image.barycentric[p][m] * corner.z();
      place += weight * corner.head<2>();
      sum += weight;
    }
    place /= sum;
    // The middle of the samples that show the triangle lies within a quarter of a pixel.
    const Eigen::Vector2d centre(p % 200 + 0.5, p / 200 + 0.5);
    const double away = (place - centre).cwiseAbs().maxCoeff();
    largest = std::max(largest, away);
    const double step = 0.25 / 3;  // of the middle of 1, 2, 3 or 4 samples
    for (const int axis : {0, 1}) {
      const double steps = (place - centre)[axis] / step;
      EXPECT_NEAR(steps, std::round(steps), 0.02);
    }
    ++compared;
  }
  EXPECT_GT(compared, 5000);
  EXPECT_LT(largest, 0.252);
}

}  // namespace
}  // namespace brindle
