#include "brindle/renderer.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/fragment_phase.h"
#include "brindle/render/parsed_words.h"
#include "brindle/shapes.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

using namespace test;

CornerWave corner_of(const StripedSurface& s, Index v) {
  return {{s.mesh.positions[v], s.waves.directions[v], s.waves.frequencies[v]}, s.z[v]};
}

/// The largest difference between the shader's phase and its twin's over all pixels that show a
/// triangle, leaving out the surroundings of singular points, where any rounding turns the phase.
struct TwinError {
  float largest = 0;
  int pixels = 0;
  int left_out = 0;
};

TwinError twin_error(const StripedSurface& s, const RenderOptions& options) {
  Studio::shared().probe.upload(s.drawing());
  const FragmentImage image = Studio::shared().probe.draw(options);
  TwinError error;
  for (std::size_t p = 0; p < image.z.size(); ++p) {
    if (image.triangle[p] == FragmentImage::kNoTriangle) continue;
    const Triangle& t = s.mesh.triangles[image.triangle[p]];
    const std::array<CornerWave, 3> corners{corner_of(s, t[0]), corner_of(s, t[1]),
                                            corner_of(s, t[2])};
    const Vec3 b = image.barycentric[p];
    const Complex z = fragment_phase(corners, b).z;
    const Complex nudged = fragment_phase(corners, b + Vec3(1e-5f, -2e-5f, 1e-5f)).z;
    ++error.pixels;
    if (std::abs(nudged - z) > 1e-2f) {
      ++error.left_out;
      continue;
    }
    error.largest = std::max(error.largest, std::abs(image.z[p] - z));
  }
  return error;
}

TEST(Renderer, ShaderAgreesWithItsTwinOnAPlaneWave) {
  const TwinError error = twin_error(plane_wave(saddle(8), Vec3::UnitX(), 12), plain_options());
  EXPECT_GT(error.pixels, 5000);
  EXPECT_EQ(error.left_out, 0);
  EXPECT_LT(error.largest, 1e-4);
}

TEST(Renderer, ShaderAgreesWithItsTwinAtBranchesSingularitiesAndFlips) {
  RenderOptions options = plain_options(320, 240);
  options.camera = {.azimuth_deg = 25, .elevation_deg = 30};
  const TwinError error = twin_error(with_flips(random_waves(saddle(6), 10)), options);
  EXPECT_GT(error.pixels, 10000);
  EXPECT_LT(error.left_out, error.pixels / 50);
  EXPECT_LT(error.largest, 1e-4);
}

TEST(Renderer, ShaderAgreesWithItsTwinOnManyStripesPerTriangle) {
  const Vec3 direction = Vec3(1, 2, 0).normalized();
  const TwinError error = twin_error(plane_wave(square(1), direction, 20), plain_options());
  EXPECT_GT(error.pixels, 5000);
  EXPECT_LT(error.largest, 1e-4);
}

TEST(Renderer, ShaderAgreesWithItsTwinFarFromTheOrigin) {
  StripedSurface surface = plane_wave(square(4), Vec3::UnitY(), 8);
  for (Vec3& p : surface.mesh.positions) p += Vec3(1000, -2000, 500);
  surface.waves.positions = surface.mesh.positions;
  const TwinError error = twin_error(surface, plain_options());
  EXPECT_GT(error.pixels, 5000);
  EXPECT_LT(error.largest, 1e-4);
}

TEST(Renderer, FragmentsCoverThePictureAndHaveWeights) {
  Studio::shared().probe.upload(plane_wave(square(2), Vec3::UnitX(), 3).drawing());
  const FragmentImage image = Studio::shared().probe.draw(plain_options(120, 120));
  int seen = 0;
  for (std::size_t p = 0; p < image.triangle.size(); ++p) {
    if (image.triangle[p] == FragmentImage::kNoTriangle) continue;
    ++seen;
    EXPECT_LT(image.triangle[p], 8u);
    EXPECT_NEAR(image.barycentric[p].sum(), 1, 1e-5);
    EXPECT_NEAR(std::abs(image.z[p]), 1, 1e-5);
  }
  EXPECT_NEAR(seen, 114 * 114, 500);  // all but the margin
}

TEST(Renderer, FramesOtherPointsIfToldTo) {
  const StripedSurface surface = plane_wave(square(2), Vec3::UnitX(), 3);
  const Vec3 center = bounding_box(surface.mesh).center();
  std::vector<Vec3> twice_as_large;
  for (const Vec3& p : surface.mesh.positions) twice_as_large.push_back(center + 2 * (p - center));
  SurfaceDrawing drawing = surface.drawing();
  drawing.framed = twice_as_large;
  Studio::shared().probe.upload(drawing);
  const FragmentImage image = Studio::shared().probe.draw(plain_options(120, 120));
  const auto seen = image.triangle.size() - static_cast<std::size_t>(std::ranges::count(
                                                image.triangle, FragmentImage::kNoTriangle));
  EXPECT_NEAR(static_cast<double>(seen), 57 * 57, 300);
}

/// What a new renderer draws that frames these points.
Image drawn_anew(const StripedSurface& surface, std::span<const Vec3> framed,
                 const RenderOptions& options) {
  Renderer renderer;
  SurfaceDrawing drawing = surface.drawing();
  drawing.framed = framed;
  renderer.upload(drawing);
  return renderer.draw(options);
}

TEST(Renderer, PicturesOneAfterTheOtherAreThoseOfNewRenderers) {
  Studio::shared();
  StripedSurface surface = plane_wave(make_shape("torus,resolution=16"), Vec3::UnitX(), 5);
  std::vector<Vec3> framed = surface.mesh.positions;
  RenderOptions options = plain_options();
  options.camera.elevation_deg = 20;
  Renderer renderer;
  renderer.upload(surface.drawing());
  Image last = renderer.draw(options);
  const auto expect_change = [&](const char* what) {
    const Image image = renderer.draw(options);
    EXPECT_EQ(image.pixels, drawn_anew(surface, framed, options).pixels) << what;
    EXPECT_NE(image.pixels, last.pixels) << what;
    EXPECT_EQ(renderer.draw(options).pixels, image.pixels) << what;
    last = image;
  };
  for (Complex& z : surface.z) z *= Complex(0, 1);
  renderer.update({.z = surface.z});
  expect_change("phases");
  options.camera.azimuth_deg = 50;
  expect_change("another view");
  options.camera.slice = parse_slice("x=50%");
  expect_change("a slice");
  options.camera.slice = parse_slice("x=60%");
  expect_change("another slice");
  options.camera.slice.reset();
  expect_change("no slice");
  for (Vec3& position : surface.mesh.positions) position.y() *= 0.5f;
  surface.waves.positions = surface.mesh.positions;
  renderer.update({.positions = surface.mesh.positions});
  expect_change("moved vertices");
  options.quality = PictureQuality::interactive;
  options.width += 40;
  expect_change("a wider draft");
  surface = plane_wave(make_shape("sphere,resolution=12"), Vec3::UnitX(), 5);
  framed = surface.mesh.positions;
  renderer.upload(surface.drawing());
  expect_change("another surface");
}

TEST(Renderer, FlippedWavesGiveTheSamePicture) {
  const StripedSurface surface = plane_wave(saddle(6), Vec3::UnitX(), 9);
  const Image one = Studio::shared().draw(surface.drawing(), plain_options());
  const Image other = Studio::shared().draw(with_flips(surface).drawing(), plain_options());
  for (std::size_t p = 0; p < one.pixels.size(); ++p) {
    ASSERT_NEAR(one.pixels[p].red, other.pixels[p].red, 2);
  }
}

TEST(Renderer, StripeWidthIsTheShareOfLight) {
  const StripedSurface surface = plane_wave(square(4), Vec3::UnitX(), 16);
  RenderOptions options = plain_options(256, 256);
  for (const float width : {0.0f, 0.2f, 0.5f, 0.8f, 1.0f}) {
    options.stripe_width = width;
    const Light light = light_in_the_middle(Studio::shared().draw(surface.drawing(), options));
    EXPECT_NEAR(light.mean, width, 0.05) << width;
  }
}

TEST(Renderer, StripesFinerThanPixelsBecomeTheirMeanWithoutMoire) {
  RenderOptions options = plain_options(128, 128);
  options.stripe_width = 0.3f;
  for (const float frequency : {150.0f, 244.0f, 400.0f, 1000.0f, 30000.0f}) {
    const StripedSurface surface = plane_wave(square(4), Vec3(3, 4, 0) / 5, frequency);
    const Light light = light_in_the_middle(Studio::shared().draw(surface.drawing(), options));
    EXPECT_NEAR(light.mean, 0.3, 0.02) << frequency;
    EXPECT_LT(light.highest - light.lowest, 0.08) << frequency;
  }
}

TEST(Renderer, WideStripesHaveFullContrast) {
  const StripedSurface surface = plane_wave(square(4), Vec3::UnitX(), 8);
  const Light light =
      light_in_the_middle(Studio::shared().draw(surface.drawing(), plain_options()));
  EXPECT_LT(light.lowest, 0.01);
  EXPECT_GT(light.highest, 0.99);
}

TEST(Renderer, TilesDoNotShow) {
  const StripedSurface surface = random_waves(saddle(5), 20);
  const std::vector<Mark> marks{{Vec3(0.4f, 0.6f, 0.1f), {1, 0, 0}}};
  SurfaceDrawing drawing = surface.drawing();
  drawing.marks = marks;
  RenderOptions options = plain_options(300, 201);
  options.transparent = false;
  for (const int supersampling : {1, 2}) {
    options.supersampling = supersampling;
    options.tile_side = 2048;
    const Image whole = Studio::shared().draw(drawing, options);
    options.tile_side = 132;
    const Image tiled = Studio::shared().draw(drawing, options);
    double difference = 0;
    for (std::size_t p = 0; p < whole.pixels.size(); ++p) {
      difference += std::abs(whole.pixels[p].red - tiled.pixels[p].red);
    }
    EXPECT_LT(difference / static_cast<double>(whole.pixels.size()), 0.05);
  }
}

TEST(Renderer, TrianglesSmallerThanPixelsKeepThePhase) {
  // More than a batch of triangles, and several to a pixel.
  const TwinError error = twin_error(plane_wave(saddle(200), Vec3::UnitX(), 9), plain_options());
  EXPECT_GT(error.pixels, 5000);
  EXPECT_EQ(error.left_out, 0);
  EXPECT_LT(error.largest, 1e-4);
}

TEST(Renderer, PictureOfTheSameStripesIsTheSameOnAFinerMesh) {
  const Image coarse =
      Studio::shared().draw(plane_wave(square(2), Vec3::UnitX(), 9).drawing(), plain_options());
  const Image fine =
      Studio::shared().draw(plane_wave(square(200), Vec3::UnitX(), 9).drawing(), plain_options());
  for (int y = 30; y < 90; ++y) {
    for (int x = 50; x < 110; ++x) ASSERT_NEAR(coarse.at(x, y).red, fine.at(x, y).red, 6);
  }
}

TEST(Renderer, SurfaceWithoutWavesIsPlain) {
  StripedSurface surface = plane_wave(square(4), Vec3::UnitX(), 8);
  for (Vec3& d : surface.waves.directions) d.setZero();
  const Light none = light_in_the_middle(Studio::shared().draw(surface.drawing(), plain_options()));
  EXPECT_EQ(none.highest, 0);
  const Light bare =
      light_in_the_middle(Studio::shared().draw({.mesh = surface.mesh}, plain_options()));
  EXPECT_EQ(bare.highest, 0);
}

TEST(Renderer, BothSidesAreLitAlike) {
  StripedSurface surface = plane_wave(square(4), Vec3::UnitX(), 8);
  RenderOptions options = plain_options();
  options.shading = true;
  const Image front = Studio::shared().draw(surface.drawing(), options);
  for (std::size_t t = 0; t < surface.mesh.triangle_count(); t += 2) {
    std::swap(surface.mesh.triangles[t][1], surface.mesh.triangles[t][2]);
  }
  const Image mixed = Studio::shared().draw(surface.drawing(), options);
  for (std::size_t p = 0; p < front.pixels.size(); ++p) {
    ASSERT_NEAR(front.pixels[p].red, mixed.pixels[p].red, 3);
  }
}

TEST(Renderer, BackgroundIsThereUnlessTransparent) {
  const Mesh mesh = square(1);
  RenderOptions options = plain_options();
  EXPECT_EQ(Studio::shared().draw({.mesh = mesh}, options).at(0, 0).alpha, 0);
  options.transparent = false;
  const Image image = Studio::shared().draw({.mesh = mesh}, options);
  EXPECT_EQ(image.at(0, 0).alpha, 255);
  EXPECT_GT(image.at(0, 0).red, 150);
}

TEST(Renderer, TriangleColorsAndMarksAreSeen) {
  const Mesh mesh = square(1);
  const std::vector<TriangleColor> colors{{{1, 0, 0}, 1}, {{0, 0, 0}, 0}};
  const std::vector<Mark> marks{{Vec3(0.25f, 0.75f, 0), {0, 1, 0}}};
  const Image image = Studio::shared().draw(
      {.mesh = mesh, .triangle_colors = colors, .marks = marks}, plain_options(200, 200));
  EXPECT_EQ(image.at(150, 150), (Pixel{255, 0, 0, 255}));  // lower right: the first triangle
  EXPECT_EQ(image.at(55, 100).red, 0);
  const Pixel mark = image.at(52, 52);
  EXPECT_GT(mark.green, 250);
  EXPECT_LT(mark.red, 10);
}

// As large beside the picture in every size, but never too small to be seen.
TEST(Renderer, MarksGrowWithThePicture) {
  const Mesh mesh = square(1);
  const std::vector<Mark> marks{{Vec3(0.5f, 0.5f, 0), {0, 1, 0}}};
  const auto width_of_mark = [&](const RenderOptions& options) {
    const Image image = Studio::shared().draw({.mesh = mesh, .marks = marks}, options);
    int width = 0;
    for (int x = 0; x < image.width; ++x) width += image.at(x, image.height / 2).green > 128;
    return width;
  };
  const int usual = width_of_mark(plain_options(1200, 900));
  EXPECT_NEAR(usual, 12, 1.5);
  EXPECT_NEAR(width_of_mark(plain_options(2400, 1800)), 2 * usual, 1.5);
  EXPECT_NEAR(width_of_mark(plain_options(2400, 900)), usual, 1.5);
  EXPECT_NEAR(width_of_mark(plain_options(160, 120)), 8, 1.5);
  RenderOptions given = plain_options(1200, 900);
  given.mark_radius = 20;
  EXPECT_NEAR(width_of_mark(given), 40, 1.5);
  EXPECT_EQ(mark_radius_of(given), 20);
  given.mark_radius = 0;
  EXPECT_THROW(width_of_mark(given), Error);
}

TEST(Renderer, HiddenMarksStayHidden) {
  Mesh mesh = square(1);
  const std::vector<Mark> marks{{Vec3(0.5f, 0.5f, -0.5f), {1, 1, 1}}};
  const Light light =
      light_in_the_middle(Studio::shared().draw({.mesh = mesh, .marks = marks}, plain_options()));
  EXPECT_EQ(light.highest, 0);
}

TEST(Renderer, EmptyMeshGivesTheBackground) {
  const Image image = Studio::shared().draw({.mesh = Mesh{}}, plain_options());
  for (const Pixel& pixel : image.pixels) ASSERT_EQ(pixel.alpha, 0);
}

TEST(Renderer, WrongSizesAreErrors) {
  const StripedSurface surface = plane_wave(square(2), Vec3::UnitX(), 3);
  SurfaceDrawing drawing = surface.drawing();
  drawing.z = drawing.z.first(3);
  EXPECT_THROW(Studio::shared().renderer.upload(drawing), Error);
  RenderOptions options;
  options.width = 100000;
  EXPECT_THROW(Studio::shared().renderer.draw(options), Error);
  options = {};
  options.stripe_width = 1.5f;
  EXPECT_THROW(Studio::shared().renderer.draw(options), Error);
}

TEST(HeadlessContext, SeveralLiveSideBySide) {
  Studio::shared();
  {
    HeadlessContext second;
    EXPECT_NE(second.renderer().find("OpenGL 4."), std::string::npos);
    HeadlessContext moved = std::move(second);
    EXPECT_FALSE(moved.renderer().empty());
  }
  Studio::shared().context.make_current();
  const Image image = Studio::shared().draw({.mesh = square(1)}, plain_options());
  EXPECT_EQ(image.at(80, 60).alpha, 255);
}

TEST(Renderer, AChangedSceneLooksLikeAnUploadedOne) {
  const StripedSurface before = plane_wave(saddle(6), Vec3::UnitX(), 8);
  const StripedSurface after = random_waves(saddle(6), 6);
  Renderer& renderer = Studio::shared().renderer;
  renderer.upload(before.drawing());
  renderer.update({.waves = &after.waves, .z = after.z});
  const Image changed = renderer.draw(plain_options());
  EXPECT_EQ(changed.pixels, Studio::shared().draw(after.drawing(), plain_options()).pixels);
  EXPECT_NE(changed.pixels, Studio::shared().draw(before.drawing(), plain_options()).pixels);
}

TEST(Renderer, MovingVerticesDoNotMoveTheCamera) {
  const StripedSurface surface = plane_wave(saddle(6), Vec3::UnitX(), 8);
  std::vector<Vec3> half = surface.mesh.positions;
  for (Vec3& p : half) p *= 0.5f;
  const auto covered = [](const Image& image) {
    return std::ranges::count_if(image.pixels, [](const Pixel& p) { return p.alpha > 127; });
  };
  Renderer& renderer = Studio::shared().renderer;
  const auto whole = covered(Studio::shared().draw(surface.drawing(), plain_options()));
  renderer.update({.positions = half});
  const auto quarter = covered(renderer.draw(plain_options()));
  EXPECT_GT(quarter, whole / 8);
  EXPECT_LT(quarter, whole / 2);
}

TEST(Renderer, RefusesChangesOfAnotherSize) {
  const StripedSurface surface = plane_wave(square(2), Vec3::UnitX(), 8);
  Studio::shared().renderer.upload(surface.drawing());
  const std::vector<Vec3> three(3);
  EXPECT_THROW(Studio::shared().renderer.update({.positions = three}), Error);
  EXPECT_THROW(Studio::shared().renderer.update({.normals = three}), Error);
}

}  // namespace
}  // namespace brindle
