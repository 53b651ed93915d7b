#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/render/parsed_words.h"
#include "brindle/renderer.h"

namespace brindle {
namespace {

const BuiltInTile kAll[] = {BuiltInTile::stripes, BuiltInTile::checker, BuiltInTile::dots,
                            BuiltInTile::arrows,  BuiltInTile::bricks,  BuiltInTile::hatch,
                            BuiltInTile::plus,    BuiltInTile::minus,   BuiltInTile::plus_minus,
                            BuiltInTile::knurl,   BuiltInTile::weave,   BuiltInTile::scales};

/// Calls `body(u, v)` for points all over a tile and beyond.
template <class Body>
void at_many_points(const Body& body) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<float> number(-2, 2);
  for (int i = 0; i < 2000; ++i) {
    const float u = number(engine);
    body(u, number(engine));
  }
}

TEST(TextureTile, NamesAreReadBack) {
  EXPECT_EQ(parse_built_in_tile("checker"), BuiltInTile::checker);
  EXPECT_EQ(parse_built_in_tile("plusminus"), BuiltInTile::plus_minus);
  EXPECT_FALSE(parse_built_in_tile("cheker"));
  EXPECT_FALSE(parse_built_in_tile(""));
  EXPECT_NE(built_in_tile_names().find("|hatch|"), std::string_view::npos);
}

TEST(TextureTile, DistancesRepeatAndNeverGrowFasterThanTheWay) {
  for (const BuiltInTile tile : kAll) {
    at_many_points([&](float u, float v) {
      const float here = tile_distance(tile, u, v);
      ASSERT_NEAR(here, tile_distance(tile, u + 1, v - 2), 1e-5f);
      const float step = 0.013f;
      ASSERT_LE(std::abs(tile_distance(tile, u + step, v) - here), 1.01f * step)
          << static_cast<int>(tile) << ' ' << u << ' ' << v;
      ASSERT_LE(std::abs(tile_distance(tile, u, v - step) - here), 1.01f * step)
          << static_cast<int>(tile) << ' ' << u << ' ' << v;
    });
  }
}

TEST(TextureTile, AllButArrowsAndScalesLookTheSameTurnedHalfWay) {
  for (const BuiltInTile tile : kAll) {
    float largest = 0;
    at_many_points([&](float u, float v) {
      largest = std::max(largest,
                         std::abs(tile_distance(tile, u, v) - tile_distance(tile, 1 - u, 1 - v)));
    });
    if (tile == BuiltInTile::arrows || tile == BuiltInTile::scales) {
      EXPECT_GT(largest, 0.1f);
    } else {
      EXPECT_LT(largest, 1e-5f) << static_cast<int>(tile);
    }
  }
}

TEST(TextureTile, SomeLookTheSameTurnedByAQuarter) {
  for (const BuiltInTile tile :
       {BuiltInTile::dots, BuiltInTile::plus, BuiltInTile::checker, BuiltInTile::knurl}) {
    at_many_points([&](float u, float v) {
      ASSERT_NEAR(tile_distance(tile, u, v), tile_distance(tile, 1 - v, u), 1e-5f);
    });
  }
}

TEST(TextureTile, ArrowsPointAlongU) {
  EXPECT_LT(tile_distance(BuiltInTile::arrows, 0.88f, 0.5f), 0);  // tip
  EXPECT_GT(tile_distance(BuiltInTile::arrows, 0.88f, 0.6f), 0);
  EXPECT_LT(tile_distance(BuiltInTile::arrows, 0.60f, 0.64f), 0);  // barb
  EXPECT_GT(tile_distance(BuiltInTile::arrows, 0.20f, 0.64f), 0);
}

TEST(TextureTile, PicturesShowTheMotifWithSmoothEdges) {
  const Image image = tile_picture(BuiltInTile::checker, 64, {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(image.at(32, 32), (Pixel{0, 0, 0, 255}));
  EXPECT_EQ(image.at(8, 32), (Pixel{255, 255, 255, 255}));
  EXPECT_EQ(image.at(8, 8), (Pixel{0, 0, 0, 255}));
  const Image arrow = tile_picture(BuiltInTile::arrows, 64, {0, 0, 0}, {1, 1, 1});
  int between = 0;
  for (const Pixel& pixel : arrow.pixels) between += pixel.red > 10 && pixel.red < 245;
  EXPECT_GT(between, 30);
}

TEST(TextureTile, TransparentPicturesLieOnTheGround) {
  Image image(2, 1);
  image.at(0, 0) = {200, 10, 10, 0};
  image.at(1, 0) = {200, 10, 10, 255};
  const Image tile = tile_picture(image, 512, {0, 0, 0}, {0, 1, 0});
  EXPECT_EQ(tile.at(0, 0), (Pixel{0, 255, 0, 255}));
  EXPECT_EQ(tile.at(1, 0), (Pixel{200, 10, 10, 255}));
}

TEST(TextureTile, ReducedPicturesKeepTheirLight) {
  Image image(1000, 3);
  for (int x = 0; x < 1000; x += 2) {
    for (int y = 0; y < 3; ++y) image.at(x, y) = {255, 255, 255, 255};
  }
  const Image small = reduced(image, 300);
  EXPECT_EQ(small.width, 250);
  EXPECT_EQ(small.height, 1);
  for (const Pixel& pixel : small.pixels) EXPECT_NEAR(pixel.red, 188, 2);  // half of the light
  EXPECT_EQ(reduced(image, 1000).pixels, image.pixels);
}

TEST(TextureTile, ReducedPicturesDoNotMixInWhatIsTransparent) {
  Image image(2, 2);
  for (Pixel& pixel : image.pixels) pixel = {0, 255, 0, 0};
  image.at(0, 0) = {255, 0, 0, 255};
  EXPECT_EQ(reduced(image, 1).at(0, 0), (Pixel{255, 0, 0, 64}));
}

}  // namespace
}  // namespace brindle
