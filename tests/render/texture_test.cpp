#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/renderer.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

using namespace test;

/// A surface with plane waves along x and y.
struct TexturedDrawing {
  StripedSurface surface;
  TextureWaves waves;
  TextureTile tile;

  SurfaceDrawing drawing() const {
    SurfaceDrawing drawing = surface.drawing();
    drawing.texture_waves = &waves;
    drawing.texture_tile = &tile;
    return drawing;
  }
  Image draw(const RenderOptions& options) const {
    return Studio::shared().draw(drawing(), options);
  }
};

TextureWaves waves_of(const StripedSurface& u, const StripedSurface& v) {
  return texture_waves(u.mesh.triangles, u.waves, u.z, v.waves, v.z);
}

TexturedDrawing plane_texture(Mesh mesh, float frequency, TextureTile tile) {
  StripedSurface u = plane_wave(mesh, Vec3::UnitX(), frequency);
  TextureWaves waves = waves_of(u, plane_wave(mesh, Vec3::UnitY(), frequency));
  return {std::move(u), std::move(waves), std::move(tile)};
}

/// Red grows along U and green along V; both wrap.
Image ramps(int side) {
  Image image(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto level = [&](int i) { return static_cast<std::uint8_t>(255 * (i + 0.5) / side); };
      image.at(x, y) = {level(x), level(side - 1 - y), 0, 255};
    }
  }
  return image;
}

float apart_on_circle(float a, float b) { return std::abs(a - b - std::round(a - b)); }

/// Calls `check` with every pixel that the texture covers whole, and U and V in it.
template <typename Check>
void for_each_texel(const TexturedDrawing& drawing, const RenderOptions& options,
                    const Image& image, Check check) {
  Studio::shared().probe.upload(drawing.drawing());
  const FragmentImage fragments = Studio::shared().probe.draw(options);
  for (std::size_t p = 0; p < image.pixels.size(); ++p) {
    const Index t = fragments.triangle[p];
    if (t == FragmentImage::kNoTriangle || image.pixels[p].alpha < 255) continue;
    const auto [u, v] =
        texture_fragment(drawing.waves.u[t], drawing.waves.v[t], fragments.barycentric[p]);
    check(image.pixels[p], texture_coordinate(u.z), texture_coordinate(v.z));
  }
}

TEST(Texture, EveryPixelShowsTheTileAtItsPhases) {
  TexturedDrawing drawing = plane_texture(saddle(5), 6, ramps(256));
  drawing.surface = with_flips(std::move(drawing.surface));
  const RenderOptions options = plain_options(320, 240);
  const Image image = drawing.draw(options);
  int compared = 0;
  for_each_texel(drawing, options, image, [&](const Pixel& pixel, float u, float v) {
    // Filters mix both ends of a ramp where it starts again.
    const auto near_end = [](float x) { return apart_on_circle(x, 0) < 0.12f; };
    if (near_end(u) || near_end(v)) return;
    ++compared;
    ASSERT_LT(apart_on_circle(u, static_cast<float>(pixel.red) / 255), 0.03f);
    ASSERT_LT(apart_on_circle(v, static_cast<float>(pixel.green) / 255), 0.03f);
  });
  EXPECT_GT(compared, 10000);
}

TEST(Texture, WherePhasesWrapNoSeamShows) {
  // One colour but for a dot in the middle: the lines where U and V start again are plain.
  const TexturedDrawing drawing = plane_texture(saddle(12), 5, BuiltInTile::dots);
  const RenderOptions options = plain_options(320, 240);
  const Image image = drawing.draw(options);
  int plain = 0;
  for_each_texel(drawing, options, image, [&](const Pixel& pixel, float u, float v) {
    if (tile_distance(BuiltInTile::dots, u, v) < 0.06f) return;
    ++plain;
    ASSERT_LE(pixel.red, 3) << u << ' ' << v;
  });
  EXPECT_GT(plain, 10000);
}

TEST(Texture, TilesSmallerThanPixelsBecomeTheirMeanWithoutMoire) {
  Image black_and_white(64, 64);
  for (int i = 0; i < 64 * 64; ++i) {
    if ((i / 64 / 8 + i / 8) % 2)
      black_and_white.pixels[static_cast<std::size_t>(i)] = {255, 255, 255, 255};
  }
  for (const TextureTile& tile :
       {TextureTile(BuiltInTile::checker), TextureTile(black_and_white)}) {
    for (const float frequency : {150.0f, 400.0f, 3000.0f}) {
      const Light light = light_in_the_middle(
          plane_texture(square(4), frequency, tile).draw(plain_options(128, 128)));
      EXPECT_NEAR(light.mean, 0.5, 0.03) << frequency;
      EXPECT_LT(light.highest - light.lowest, 0.12) << frequency;
    }
  }
}

TEST(Texture, AtASlantTilesStaySharpAcrossAndSmoothAlong) {
  const TexturedDrawing drawing = plane_texture(square(20), 40, BuiltInTile::stripes);
  RenderOptions options = plain_options(400, 300);
  options.camera = {.azimuth_deg = 0, .elevation_deg = 86};
  const Image image = drawing.draw(options);
  // Seen almost edge on: the stripes still have most of their contrast.
  double sum = 0, squares = 0;
  int count = 0;
  for (std::size_t p = 0; p < image.pixels.size(); ++p) {
    if (image.pixels[p].alpha < 255) continue;
    const double value = image.pixels[p].red / 255.0;
    sum += value;
    squares += value * value;
    ++count;
  }
  ASSERT_GT(count, 1000);
  const double mean = sum / count;
  EXPECT_GT(std::sqrt(squares / count - mean * mean), 0.3);
}

TEST(Texture, EdgesOfAMotifStaySharpAtAnyMagnification) {
  for (const float frequency : {1.0f, 0.05f, 0.01f}) {
    TexturedDrawing drawing = plane_texture(square(1), frequency, BuiltInTile::stripes);
    // The border of the stripe, a quarter of a period from its crest, in the middle of the picture.
    for (CornerWaves& corners : drawing.waves.u) {
      for (CornerWave& corner : corners) {
        const float x = corner.wave.position.x() - 0.5f;
        corner.z = std::polar(1.0f, kTurn * frequency * x);
      }
    }
    const Image image = drawing.draw(plain_options(200, 200));
    int between = 0;
    for (int x = 20; x < 180; ++x)
      between += image.at(x, 100).red > 20 && image.at(x, 100).red < 235;
    EXPECT_GE(between, frequency < 1 ? 0 : 1);
    EXPECT_LE(between, 5) << frequency;
  }
}

TEST(Texture, OnePixelColoursAllAndTransparencyShowsTheSurface) {
  Image one(1, 1);
  one.at(0, 0) = {0, 255, 0, 255};
  const Image green = plane_texture(square(3), 4, one).draw(plain_options());
  EXPECT_EQ(green.at(80, 60), (Pixel{0, 255, 0, 255}));
  one.at(0, 0) = {0, 255, 0, 0};
  RenderOptions options = plain_options();
  options.base_color = {1, 0, 0};
  const Image through = plane_texture(square(3), 4, one).draw(options);
  EXPECT_EQ(through.at(80, 60), (Pixel{255, 0, 0, 255}));
}

TEST(Texture, PicturesBeyondTheDriversTexturesAreReduced) {
  Image wide(20000, 1);
  for (int x = 0; x < 20000; ++x)
    wide.at(x, 0) = {static_cast<std::uint8_t>(x < 10000 ? 0 : 255), 0, 0, 255};
  const Light light =
      light_in_the_middle(plane_texture(square(3), 4, wide).draw(plain_options(256, 256)));
  EXPECT_NEAR(light.mean, 0.5, 0.05);
  EXPECT_GT(light.highest - light.lowest, 0.9);
}

TEST(Texture, TrianglesWithoutWavesShowTheSurface) {
  TexturedDrawing drawing = plane_texture(square(2), 4, BuiltInTile::checker);
  for (CornerWaves& corners : drawing.waves.v) corners[1].wave.direction.setZero();
  EXPECT_EQ(light_in_the_middle(drawing.draw(plain_options())).highest, 0);
}

TEST(Texture, SplitTrianglesFitTheirNeighbours) {
  // Random directions: many triangles cannot be oriented.
  const StripedSurface u = random_waves(square(6), 3);
  StripedSurface v = u;
  for (Vec3& d : v.waves.directions) d = Vec3(-d.y(), d.x(), 0);
  TexturedDrawing drawing{u, waves_of(u, v), BuiltInTile::checker};
  orient_corners(drawing.waves);
  const RenderOptions options = plain_options(480, 480);
  const Image image = drawing.draw(options);
  Studio::shared().probe.upload(drawing.drawing());
  const FragmentImage fragments = Studio::shared().probe.draw(options);
  int compared = 0, wrong = 0;
  for (std::size_t p = 0; p < image.pixels.size(); ++p) {
    const Index t = fragments.triangle[p];
    if (t == FragmentImage::kNoTriangle || image.pixels[p].alpha < 255) continue;
    const auto [a, b] =
        texture_fragment(drawing.waves.u[t], drawing.waves.v[t], fragments.barycentric[p]);
    const float distance =
        tile_distance(BuiltInTile::checker, texture_coordinate(a.z), texture_coordinate(b.z));
    if (std::abs(distance) < 0.15f) continue;
    ++compared;
    wrong += (image.pixels[p].red > 127) != (distance < 0);
  }
  EXPECT_GT(compared, 20000);
  EXPECT_LT(wrong, compared / 50);  // around singular points, where the phase turns within pixels
}

TEST(Texture, RefusesWavesForAnotherNumberOfTriangles) {
  TexturedDrawing drawing = plane_texture(square(2), 4, BuiltInTile::dots);
  drawing.waves.v.pop_back();
  EXPECT_THROW(Studio::shared().renderer.upload(drawing.drawing()), Error);
}

/// A wave along x that has one more crest above a point than below it.
TexturedDrawing with_branch(int n, float frequency, TextureTile tile) {
  TexturedDrawing drawing = plane_texture(square(n), frequency, std::move(tile));
  StripedSurface u = drawing.surface;
  for (std::size_t v = 0; v < u.z.size(); ++v) {
    const Vec3& p = u.mesh.positions[v];
    u.z[v] *= std::polar(1.0f, std::atan2(p.y() - 0.4871f, p.x() - 0.5133f));
  }
  drawing.waves = waves_of(u, plane_wave(u.mesh, Vec3::UnitY(), frequency));
  drawing.surface = std::move(u);
  return drawing;
}

BrokenTiles broken_in(const TexturedDrawing& drawing) {
  return broken_tiles(drawing.surface.mesh.triangles, drawing.waves, tile_motifs(drawing.tile));
}

Image draw_whole(const TexturedDrawing& drawing, const BrokenTiles& broken,
                 const RenderOptions& options) {
  SurfaceDrawing whole = drawing.drawing();
  whole.broken_tiles = &broken;
  return Studio::shared().draw(whole, options);
}

/// A picture with room around its motif, which is not in the middle.
Image own_picture() {
  Image image(32, 32);
  std::ranges::fill(image.pixels, Pixel{0, 0, 0, 0});
  for (int y = 4; y < 18; ++y) {
    for (int x = 8; x < 28; ++x) image.at(x, y) = {255, 255, 255, 255};
  }
  return image;
}

TEST(WholeTiles, PicturesLeaveOutWhatTheProcessorDoes) {
  for (const TextureTile& tile :
       {TextureTile(BuiltInTile::dots), TextureTile(BuiltInTile::arrows),
        TextureTile(BuiltInTile::plus_minus), TextureTile(own_picture())}) {
    const TexturedDrawing drawing = with_branch(37, 9, tile);
    const BrokenTiles broken = broken_in(drawing);
    const RenderOptions options = plain_options(300, 300);
    const Image cut = drawing.draw(options), whole = draw_whole(drawing, broken, options);
    Studio::shared().probe.upload(drawing.drawing());
    const FragmentImage fragments = Studio::shared().probe.draw(options);
    std::size_t kept = 0, left_out = 0, differ = 0;
    for (std::size_t p = 0; p < cut.pixels.size(); ++p) {
      const Index t = fragments.triangle[p];
      if (t == FragmentImage::kNoTriangle || cut.pixels[p].alpha < 255) continue;
      if (cut.pixels[p].red < 250) continue;  // beside motifs, or on their borders
      const Vec3& b = fragments.barycentric[p];
      const TextureFragment f = texture_fragment(drawing.waves.u[t], drawing.waves.v[t], b);
      const bool is =
          broken.is_broken(t, b, {texture_coordinate(f.u.z), texture_coordinate(f.v.z)});
      differ += (whole.pixels[p].red < 128) != is;
      ++(is ? left_out : kept);
    }
    EXPECT_EQ(differ, 0U);
    EXPECT_GT(kept, 1500U);
    EXPECT_GT(left_out, 100U);
  }
}

/// Pixels of every motif in a picture of white ones on black.
std::vector<int> motif_sizes(const Image& image) {
  std::vector<std::uint8_t> seen(image.pixels.size());
  std::vector<int> sizes;
  for (std::size_t start = 0; start < image.pixels.size(); ++start) {
    std::vector<std::size_t> next;
    const auto add = [&](std::size_t p) {
      if (seen[p] || image.pixels[p].red < 128) return;
      seen[p] = 1;
      next.push_back(p);
    };
    add(start);
    int size = 0;
    const auto width = static_cast<std::size_t>(image.width);
    for (; !next.empty(); ++size) {
      const std::size_t p = next.back();
      next.pop_back();
      for (const std::size_t q : {p - 1, p + 1, p - width, p + width}) {
        if (q < image.pixels.size()) add(q);
      }
    }
    if (size > 0) sizes.push_back(size);
  }
  return sizes;
}

TEST(WholeTiles, AtABranchAndABorderNoTileIsShownInPart) {
  for (const BuiltInTile tile : {BuiltInTile::dots, BuiltInTile::arrows, BuiltInTile::plus}) {
    const TexturedDrawing drawing = with_branch(60, 9.3f, tile);
    const BrokenTiles broken = broken_in(drawing);
    const RenderOptions options = plain_options(700, 700);
    std::vector<int> cut = motif_sizes(drawing.draw(options));
    std::vector<int> whole = motif_sizes(draw_whole(drawing, broken, options));
    ASSERT_GT(whole.size(), 40U);
    EXPECT_GT(cut.size(), whole.size());
    const auto middle = whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2);
    std::ranges::nth_element(whole, middle);
    // Next to a branch motifs are out of shape, but all there.
    const double full = *middle;
    const auto [least, most] = std::ranges::minmax(whole);
    EXPECT_GT(least, 0.6 * full) << static_cast<int>(tile);
    EXPECT_LT(most, 1.6 * full) << static_cast<int>(tile);
    EXPECT_LT(std::ranges::min(cut), 0.5 * full) << static_cast<int>(tile);
  }
}

TEST(WholeTiles, JointsOfBricksGoOnAtABranch) {
  const TexturedDrawing drawing = with_branch(60, 6.3f, BuiltInTile::bricks);
  const BrokenTiles broken = broken_in(drawing);
  const RenderOptions options = plain_options(400, 400);
  const Image cut = drawing.draw(options), split = draw_whole(drawing, broken, options);
  std::size_t more = 0, less = 0;
  for (std::size_t p = 0; p < cut.pixels.size(); ++p) {
    more += split.pixels[p].red > cut.pixels[p].red;
    less += split.pixels[p].red < 55 && cut.pixels[p].red > 200;
  }
  EXPECT_EQ(more, 0U);
  // A joint 0.07 wide and up to half a course long, of tiles 63 pixels wide.
  EXPECT_GT(less, 20U);
  EXPECT_LT(less, 300U);
  // The brick that went round the end of a joint has become two.
  EXPECT_EQ(motif_sizes(split).size(), motif_sizes(cut).size() + 1);
}

TEST(WholeTiles, WhatHasAShapeOfItsOwnHasRoomAroundIt) {
  for (const auto& [tile, own] : {std::pair(BuiltInTile::dots, true),
                                  {BuiltInTile::arrows, true},
                                  {BuiltInTile::plus, true},
                                  {BuiltInTile::minus, true},
                                  {BuiltInTile::plus_minus, true},
                                  {BuiltInTile::bricks, true},
                                  {BuiltInTile::checker, false},
                                  {BuiltInTile::stripes, false},
                                  {BuiltInTile::hatch, false}}) {
    EXPECT_EQ(has_own_shape(tile), own) << static_cast<int>(tile);
    const TileMotifs motifs = tile_motifs(tile);
    if (motifs.layout == TileLayout::courses) continue;
    const bool corner = motifs.layout == TileLayout::middle_and_corner;
    for (int i = 0; i < 10000; ++i) {
      const Eigen::Vector2f uv(0.01f * static_cast<float>(i % 100),
                               0.01f * static_cast<float>(i / 100));
      if (tile_distance(tile, uv.x(), uv.y()) > 0) continue;
      const Eigen::Vector2f from_middle = uv - Eigen::Vector2f(0.5f, 0.5f);
      const Eigen::Vector2f from_corner = (uv.array() - uv.array().round()).matrix();
      EXPECT_TRUE(motifs.extents[0].contains(from_middle) ||
                  (corner && motifs.extents[1].contains(from_corner)))
          << static_cast<int>(tile) << ": " << uv.transpose();
    }
  }
  EXPECT_TRUE(has_own_shape(own_picture()));
  const auto& extent = tile_motifs(own_picture()).extents[0];
  EXPECT_EQ(extent.min(), Eigen::Vector2f(8 / 32.0f - 0.5f, 14 / 32.0f - 0.5f));
  EXPECT_EQ(extent.max(), Eigen::Vector2f(28 / 32.0f - 0.5f, 28 / 32.0f - 0.5f));
  Image up_to_the_side = own_picture();
  up_to_the_side.at(0, 9) = {0, 0, 0, 1};
  EXPECT_FALSE(has_own_shape(up_to_the_side));
}

}  // namespace
}  // namespace brindle
