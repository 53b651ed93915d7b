#include "brindle/styled_picture.h"

#include <algorithm>
#include <complex>
#include <cstdlib>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/glyphs.h"
#include "brindle/mesh.h"
#include "brindle/shapes.h"
#include "progress_reports.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

using namespace test;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A small picture from straight ahead, without light or background.
StyledOptions styled_options(int width = 160, int height = 120) {
  StyledOptions options;
  options.render = plain_options(width, height);
  return options;
}

Image draw_styled(const std::vector<StyledSurface>& surfaces, const StyledOptions& options) {
  Studio& studio = Studio::shared();
  static StyledRenderer renderer;
  renderer.upload(surfaces);
  Image image = renderer.draw(options);
  studio.context.check_errors("drawing the test picture");
  return image;
}

Strokes strokes_of(const StripedSurface& s) {
  return {.waves = &s.waves, .z = s.z, .color = {1, 1, 1}};
}

/// A square in front of another one, which is a little larger so that the camera frames it.
struct Sheets {
  StripedSurface front = plane_wave(square(8), Vec3::UnitX(), 6);
  StripedSurface back = plane_wave(square(8), Vec3::UnitY(), 5);

  Sheets() {
    for (Vec3& p : front.mesh.positions) p.z() = 0.05f;
    front.waves.positions = front.mesh.positions;
  }

  StyledSurface seen_behind() const {
    return {.mesh = back.mesh, .color = {0.2f, 0.5f, 0.3f}, .strokes = {strokes_of(back)}};
  }
  /// Red where it has not been discarded.
  StyledSurface discarded_front() const {
    StyledSurface surface{
        .mesh = front.mesh, .strokes = {strokes_of(front)}, .between = BetweenStrokes::discarded};
    surface.strokes[0].color = {1, 0, 0};
    return surface;
  }
};

TEST(StyledPicture, BetweenDiscardedStrokesIsExactlyWhatLiesBehind) {
  const Sheets sheets;
  const StyledSurface behind = sheets.seen_behind();
  StyledSurface front = sheets.discarded_front();
  StyledOptions options = styled_options();
  StyledSurface nothing = front;
  nothing.strokes[0].width = 0;  // so that the camera stands still
  const Image alone = draw_styled({nothing, behind}, options);
  const Image both = draw_styled({front, behind}, options);
  int seen_through = 0, strokes = 0;
  for (int y = 20; y < 100; ++y) {
    for (int x = 50; x < 110; ++x) {
      const Pixel pixel = both.at(x, y);
      if (pixel == Pixel{255, 0, 0, 255}) {
        ++strokes;
      } else if (pixel == alone.at(x, y)) {
        ++seen_through;
      }
    }
  }
  // All others lie on the borders of strokes.
  EXPECT_GT(strokes, 80 * 60 / 4);
  EXPECT_GT(seen_through, 80 * 60 / 4);
  EXPECT_GT(strokes + seen_through, 80 * 60 * 3 / 5);
}

// Whether it is discarded is found out once a pixel of a draft, and for each of its samples
// otherwise.
TEST(StyledPicture, InDraftsPixelsAreStrokesOrWhatLiesBehind) {
  const Sheets sheets;
  const StyledSurface behind = sheets.seen_behind();
  StyledSurface front = sheets.discarded_front();
  StyledOptions options = styled_options();
  const Image final = draw_styled({front, behind}, options);
  options.render.quality = PictureQuality::interactive;
  const Image draft = draw_styled({front, behind}, options);
  front.strokes[0].width = 0;
  const Image alone = draw_styled({front, behind}, options);
  constexpr Pixel kStroke{255, 0, 0, 255};
  int strokes = 0, lost = 0;
  for (int y = 20; y < 100; ++y) {
    for (int x = 50; x < 110; ++x) {
      const bool stroke = draft.at(x, y) == kStroke;
      EXPECT_TRUE(stroke || draft.at(x, y) == alone.at(x, y)) << x << ", " << y;
      strokes += stroke;
      lost += final.at(x, y) == kStroke && !stroke;
    }
  }
  EXPECT_GT(strokes, 80 * 60 / 4);
  EXPECT_LT(strokes, 80 * 60 * 3 / 4);
  EXPECT_EQ(lost, 0);
}

/// Squares one behind the other, of which each has strokes where those in front of it have none:
/// all strokes together cover all of it.
StripedSurface stack_of_sheets(int count) {
  Mesh mesh;
  std::vector<float> shifts;
  for (int sheet = 0; sheet < count; ++sheet) {
    Mesh one = square(8);
    for (Vec3& p : one.positions) p.z() = -0.02f * static_cast<float>(sheet);
    shifts.resize(shifts.size() + one.vertex_count(),
                  static_cast<float>(sheet) / static_cast<float>(count));
    append(one, mesh);
  }
  StripedSurface stack = plane_wave(mesh, Vec3::UnitX(), 3);
  for (std::size_t v = 0; v < stack.z.size(); ++v) {
    stack.z[v] *= std::polar(1.0f, 2 * std::numbers::pi_v<float> * shifts[v]);
  }
  return stack;
}

/// The same in red, in parallel projection.
Image draft_of_sheets(const StripedSurface& stack, int count) {
  StyledSurface surface{.mesh = stack.mesh,
                        .strokes = {strokes_of(stack)},
                        .between = BetweenStrokes::discarded,
                        .shading = false};
  surface.strokes[0].color = {1, 0, 0};
  surface.strokes[0].width = 1.2f / static_cast<float>(count);
  StyledOptions options = styled_options();
  options.render.quality = PictureQuality::interactive;
  options.render.camera.projection = Projection::orthographic;
  return draw_styled({surface}, options);
}

TEST(StyledPicture, DraftsFindTheNearestOfManySheetsWhateverTheirOrder) {
  constexpr int kSheets = 6;
  StripedSurface stack = stack_of_sheets(kSheets);
  const Image draft = draft_of_sheets(stack, kSheets);
  for (int y = 20; y < 100; ++y) {
    for (int x = 50; x < 110; ++x) {
      EXPECT_EQ(draft.at(x, y), (Pixel{255, 0, 0, 255})) << x << ", " << y;
    }
  }
  std::ranges::reverse(stack.mesh.triangles);
  EXPECT_EQ(draft_of_sheets(stack, kSheets).pixels, draft.pixels);
}

// There is room for so many triangles a pixel; what has none is left out.
TEST(StyledPicture, DraftsOfMoreSheetsThanThereIsRoomForHaveSomeOfThem) {
  constexpr int kSheets = 60;
  const Image draft = draft_of_sheets(stack_of_sheets(kSheets), kSheets);
  const auto red = std::ranges::count(draft.pixels, Pixel{255, 0, 0, 255});
  EXPECT_GT(red, 160 * 120 / 20);
}

TEST(StyledPicture, WithoutStrokesBetweenTheySeeTheBackground) {
  const Sheets sheets;
  const StyledSurface front{.mesh = sheets.front.mesh,
                            .strokes = {strokes_of(sheets.front)},
                            .between = BetweenStrokes::discarded};
  const Image image = draw_styled({front}, styled_options());
  const auto transparent = std::ranges::count(image.pixels, std::uint8_t{0}, &Pixel::alpha);
  const auto opaque = std::ranges::count(image.pixels, std::uint8_t{255}, &Pixel::alpha);
  EXPECT_GT(transparent, 160 * 120 / 3);
  EXPECT_GT(opaque, 160 * 120 / 8);
}

/// The share of white light in columns of the picture's middle, for a square whose values follow x.
double white_share(const Image& image, int first_row, int last_row) {
  double sum = 0;
  int count = 0;
  for (int y = first_row; y < last_row; ++y) {
    for (int x = image.width * 3 / 8; x < image.width * 5 / 8; ++x, ++count) {
      sum += linear_light({static_cast<float>(image.at(x, y).red) / 255, 0, 0})[0];
    }
  }
  return sum / count;
}

TEST(StyledPicture, WidthFollowsTheValue) {
  const StripedSurface s = plane_wave(square(16), Vec3::UnitX(), 24);
  std::vector<float> values;
  for (const Vec3& p : s.mesh.positions) values.push_back(10 + 5 * p.y());
  const std::vector<float> widths = rescaled(values, 10, 15, 0.1f, 0.9f);
  StyledSurface surface{.mesh = s.mesh, .color = {0, 0, 0}, .strokes = {strokes_of(s)}};
  surface.strokes[0].widths = widths;
  const Image image = draw_styled({surface}, styled_options(400, 400));
  std::vector<int> rows;
  for (int y = 0; y < 400; ++y) {
    if (image.at(200, y).alpha == 255) rows.push_back(y);
  }
  const int top = rows.front(), bottom = rows.back();
  for (double place = 0.1; place < 0.95; place += 0.1) {
    const int row = bottom - static_cast<int>(place * (bottom - top));
    const double wanted = 0.1 + 0.8 * place;
    EXPECT_NEAR(white_share(image, row - 4, row + 5), wanted, 0.05 * wanted) << place;
  }
}

TEST(StyledPicture, WidthInPixelsIsTheSameNearAndFar) {
  // A floor that runs away from the viewer.
  StripedSurface s = plane_wave(square(32), Vec3::UnitX(), 8);
  StyledSurface surface{.mesh = s.mesh, .color = {0, 0, 0}, .strokes = {strokes_of(s)}};
  surface.strokes[0].unit = WidthUnit::pixels;
  surface.strokes[0].width = 3;
  StyledOptions options = styled_options(400, 400);
  options.render.camera.elevation_deg = -60;
  const Image image = draw_styled({surface}, options);
  const auto run_lengths = [&](int row) {
    double light = 0;
    int count = 0;
    for (int x = 0; x < image.width; ++x) {
      const Pixel& pixel = image.at(x, row);
      light += linear_light({static_cast<float>(pixel.red) / 255, 0, 0})[0];
      const bool begins = pixel.red > 127 && (x == 0 || image.at(x - 1, row).red <= 127);
      count += begins ? 1 : 0;
    }
    return light / count;
  };
  EXPECT_NEAR(run_lengths(150), 3, 0.45);
  EXPECT_NEAR(run_lengths(250), 3, 0.45);
}

TEST(StyledPicture, WhereAValueIsNoneTheSurfaceIsPlain) {
  const StripedSurface s = plane_wave(square(16), Vec3::UnitX(), 24);
  std::vector<float> widths;
  for (const Vec3& p : s.mesh.positions) widths.push_back(p.y() > 0.5f ? kNaN : 0.5f);
  StyledSurface surface{.mesh = s.mesh, .color = {0, 0, 1}, .strokes = {strokes_of(s)}};
  surface.strokes[0].widths = widths;
  for (const BetweenStrokes between : {BetweenStrokes::surface, BetweenStrokes::discarded}) {
    surface.between = between;
    const Image image = draw_styled({surface}, styled_options());
    for (int x = 60; x < 100; ++x) EXPECT_EQ(image.at(x, 30), (Pixel{0, 0, 255, 255}));
  }
}

TEST(StyledPicture, ColorsFollowTheMapAndTheThreshold) {
  const StripedSurface s = plane_wave(square(16), Vec3::UnitX(), 24);
  std::vector<float> places;
  for (const Vec3& p : s.mesh.positions) places.push_back(p.y());
  const StyledSurface surface{.mesh = s.mesh, .color_places = places};
  StyledOptions options = styled_options(300, 300);
  options.scale = {ColorMap::magma, 0.7f, {0, 1, 0}};
  const Image image = draw_styled({surface}, options);
  int top = 0;
  while (image.at(150, top).alpha < 255) ++top;
  int bottom = 299;
  while (image.at(150, bottom).alpha < 255) --bottom;
  for (double place = 0.05; place < 1; place += 0.1) {
    const int row = bottom - static_cast<int>(std::lround(place * (bottom - top)));
    const Color wanted =
        place > 0.7 ? Color{0, 1, 0} : map_color(ColorMap::magma, static_cast<float>(place));
    EXPECT_NEAR(image.at(150, row).red, 255 * wanted.red, 4) << place;
    EXPECT_NEAR(image.at(150, row).green, 255 * wanted.green, 4) << place;
    EXPECT_NEAR(image.at(150, row).blue, 255 * wanted.blue, 4) << place;
  }
}

TEST(StyledPicture, OpacityMixesLight) {
  const StripedSurface s = plane_wave(square(4), Vec3::UnitX(), 3);
  StyledSurface surface{.mesh = s.mesh, .color = {0, 0, 0}, .strokes = {strokes_of(s)}};
  surface.strokes[0].width = 1;
  surface.strokes[0].opacity = 0.25f;
  const Image image = draw_styled({surface}, styled_options());
  EXPECT_NEAR(light_in_the_middle(image).mean, 0.25, 0.01);
}

TEST(StyledPicture, StrokesGrowBetweenWhereTheyAreFarApart) {
  const StripedSurface s = plane_wave(square(4), Vec3::UnitX(), 2);
  StyledSurface surface{.mesh = s.mesh, .color = {0, 0, 0}, .strokes = {strokes_of(s)}};
  const auto strokes_at_size = [&](int side) {
    const Image image = draw_styled({surface}, styled_options(side, side));
    int count = 0;
    for (int x = 1; x < side; ++x) {
      count += image.at(x, side / 2).red > 127 && image.at(x - 1, side / 2).red <= 127 ? 1 : 0;
    }
    return count;
  };
  const int alone = strokes_at_size(400);
  surface.strokes[0].spacing = 20;
  surface.strokes[0].unit = WidthUnit::pixels;
  surface.strokes[0].width = 4;
  const int near = strokes_at_size(400), far = strokes_at_size(200);
  EXPECT_LE(alone, 3);
  EXPECT_GE(near, 8);
  EXPECT_NEAR(near, 2 * far, 2);
}

TEST(StyledPicture, ASurfaceFarFromAnotherOnesZeroStaysInPlace) {
  const Sheets sheets;
  Mesh moved = sheets.back.mesh;
  moved.origin = Eigen::Vector3d(1000, 0, 0);
  for (Vec3& p : moved.positions) p.x() -= 1000;
  const StyledSurface front{.mesh = sheets.front.mesh, .color = {1, 0, 0}};
  const Image here =
      draw_styled({front, {.mesh = sheets.back.mesh, .color = {0, 1, 0}}}, styled_options());
  const Image there = draw_styled({front, {.mesh = moved, .color = {0, 1, 0}}}, styled_options());
  EXPECT_EQ(here.pixels, there.pixels);
}

/// Waves U and V along x and y, one tile on each square of `frequency` to the unit.
TextureWaves grid_waves(const Mesh& mesh, float frequency) {
  TextureWaves waves;
  for (const Triangle& t : mesh.triangles) {
    CornerWaves u, v;
    for (int m = 0; m < 3; ++m) {
      const Vec3& p = mesh.positions[t[m]];
      u[m] = {{p, Vec3::UnitX(), frequency}, std::polar(1.0f, kTurn * (frequency * p.x() - 0.25f))};
      v[m] = {{p, Vec3::UnitY(), frequency}, std::polar(1.0f, kTurn * (frequency * p.y() - 0.25f))};
    }
    waves.u.push_back(u);
    waves.v.push_back(v);
  }
  return waves;
}

TEST(StyledPicture, TilesFollowRegionsAndAreNotCut) {
  const Mesh mesh = square(16);
  const TextureWaves waves = grid_waves(mesh, 8);
  std::vector<float> values;
  for (const Vec3& p : mesh.positions) values.push_back(p.x() - 0.53f);  // within a tile
  RegionTexture texture{.waves = &waves, .values = values};
  texture.tiles = {{BuiltInTile::dots, {1, 0, 0}}, {BuiltInTile::dots, {0, 1, 0}, 0.0f}};
  StyledSurface surface{.mesh = mesh, .color = {0, 0, 0}, .texture = texture};
  const Image image = draw_styled({surface}, styled_options(320, 320));
  int mixed = 0, red = 0, green = 0;
  int left = 0;
  while (image.at(left, 160).alpha < 255) ++left;
  const double side = 320 - 2 * left;
  for (int column = 0; column < 8; ++column) {
    const int x = left + static_cast<int>(side * (column + 0.5) / 8);
    const int y = 160 + static_cast<int>(side / 16);
    int reds = 0, greens = 0;
    for (int dx = -12; dx <= 12; ++dx) {
      reds += image.at(x + dx, y).red > 128 ? 1 : 0;
      greens += image.at(x + dx, y).green > 128 ? 1 : 0;
    }
    mixed += reds > 0 && greens > 0 ? 1 : 0;
    red += reds > 4 ? 1 : 0;
    green += greens > 4 ? 1 : 0;
  }
  EXPECT_EQ(mixed, 0);
  EXPECT_EQ(red, 4);
  EXPECT_EQ(green, 4);
}

/// Red above, green below, and transparent but for a frame round the middle.
Image two_colored_tile() {
  Image tile;
  tile.width = tile.height = 64;
  tile.pixels.resize(64 * 64, {0, 0, 0, 0});
  for (int y = 16; y < 48; ++y) {
    for (int x = 16; x < 48; ++x) {
      tile.pixels[64 * y + x] = y < 32 ? Pixel{255, 0, 0, 255} : Pixel{0, 255, 0, 255};
    }
  }
  return tile;
}

TEST(StyledPicture, BesideDiscardedTilesIsExactlyWhatLiesBehind) {
  const Mesh mesh = square(16);
  Mesh behind = square(16);
  for (Vec3& p : behind.positions) p.z() -= 0.05f;
  const TextureWaves waves = grid_waves(mesh, 4);
  RegionTexture texture{.waves = &waves};
  texture.tiles = {{two_colored_tile()}};
  const StyledSurface tiles{
      .mesh = mesh, .between = BetweenStrokes::discarded, .shading = false, .texture = texture};
  const StyledSurface ground{.mesh = behind, .color = {0, 0, 1}, .shading = false};
  const Image alone = draw_styled({ground}, styled_options(256, 256));
  const Image both = draw_styled({ground, tiles}, styled_options(256, 256));
  int red = 0, green = 0, blue = 0, mixed = 0, all = 0;
  for (int y = 64; y < 192; ++y) {
    for (int x = 64; x < 192; ++x) {
      const Pixel p = both.at(x, y);
      ++all;
      red += p.red > 250 && p.green < 5 && p.blue < 5;
      green += p.green > 250 && p.red < 5 && p.blue < 5;
      blue += p == alone.at(x, y);
      mixed += p.blue > 5 && p.blue < 250;
    }
  }
  // A quarter of every tile is opaque, half of it red.
  EXPECT_NEAR(static_cast<double>(red) / all, 0.125, 0.03);
  EXPECT_NEAR(static_cast<double>(green) / all, 0.125, 0.03);
  EXPECT_NEAR(static_cast<double>(blue) / all, 0.75, 0.06);
  EXPECT_LT(mixed, all / 12);
}

// A motif has the colour of the value in its tile's middle, wherever in it one looks.
TEST(StyledPicture, MotifsHaveOneColorEach) {
  const Mesh mesh = square(16);
  const TextureWaves waves = grid_waves(mesh, 4);
  RegionTexture texture{.waves = &waves};
  texture.tiles = {{BuiltInTile::dots, {1, 0, 0}}};
  StyledOptions options = styled_options(256, 256);
  const auto drawn = [&](const std::vector<float>& places, BetweenStrokes between) {
    texture.color_places = places;
    const StyledSurface surface{
        .mesh = mesh, .color = {0, 0, 1}, .between = between, .shading = false, .texture = texture};
    return draw_styled({surface}, options);
  };
  std::vector<float> rising;
  for (const Vec3& p : mesh.positions) rising.push_back(p.x());
  for (const BetweenStrokes between : {BetweenStrokes::surface, BetweenStrokes::discarded}) {
    const Image own = drawn(std::vector<float>(rising.size(), kNaN), between);
    EXPECT_EQ(own.pixels, drawn({}, between).pixels);
    const Image image = drawn(rising, between);
    std::vector<Pixel> colors;  // that differ by more than rounding does
    for (std::size_t p = 0; p < own.pixels.size(); ++p) {
      if (!(own.pixels[p] == Pixel{255, 0, 0, 255})) continue;
      const Pixel& pixel = image.pixels[p];
      const auto is_alike = [&](const Pixel& other) {
        return std::abs(pixel.red - other.red) + std::abs(pixel.green - other.green) +
                   std::abs(pixel.blue - other.blue) <
               8;
      };
      if (std::ranges::none_of(colors, is_alike)) colors.push_back(pixel);
    }
    EXPECT_EQ(colors.size(), 4u);  // columns of dots
  }
  const std::vector<float> few(3);
  EXPECT_THROW(drawn(few, BetweenStrokes::surface), Error);
}

TEST(StyledPicture, QuadsShowTheirPictureUprightAndBeyondTheSilhouette) {
  Sample sample;
  sample.position = Vec3::Zero();
  sample.direction_u = Vec3(1, 0, 0);
  sample.direction_v = Vec3(0, 1, 0);
  sample.normal = Vec3(0, 0, 1);
  sample.spacing_u = sample.spacing_v = 2;
  const Glyphs quads =
      glyphs_at(std::span(&sample, 1), GlyphShape::quad, glyph_sizes(std::span(&sample, 1), 1));
  RegionTexture texture{.waves = &quads.waves};
  texture.tiles = {{two_colored_tile()}};
  Mesh small = square(1);  // half as wide as the opaque part
  for (Vec3& p : small.positions) p = 0.5f * (p - Vec3(0.5f, 0.5f, p.z()));
  const StyledSurface ground{.mesh = small, .color = {0, 0, 1}, .shading = false};
  const StyledSurface motif{.mesh = quads.mesh,
                            .normals = quads.normals,
                            .between = BetweenStrokes::discarded,
                            .shading = false,
                            .texture = texture};
  const Image image = draw_styled({ground, motif}, styled_options(200, 200));
  const auto is_red = [&](int x, int y) {
    return image.at(x, y).red > 200 && image.at(x, y).green < 50;
  };
  const auto is_green = [&](int x, int y) {
    return image.at(x, y).green > 200 && image.at(x, y).red < 50;
  };
  int first = 200, last = 0;
  for (int x = 0; x < 200; ++x) {
    if (is_red(x, 92)) first = std::min(first, x), last = x;
  }
  ASSERT_LT(first, last);
  EXPECT_NEAR(first + last, 199, 3);
  EXPECT_TRUE(is_green((first + last) / 2, 108));
  EXPECT_FALSE(is_red(first - 4, 92));
  // No blue is left: the picture covers the square and reaches beyond it.
  int blue = 0;
  for (const Pixel& p : image.pixels) blue += p.blue > 200 && p.red < 50 ? 1 : 0;
  EXPECT_EQ(blue, 0);
}

TEST(StyledPicture, AShiftedTextureRepeatsAfterATile) {
  const Mesh mesh = square(16);
  const TextureWaves waves = grid_waves(mesh, 6);
  const auto shifted = [&](float u) {
    RegionTexture texture{.waves = &waves, .shift = {u, 0}};
    texture.tiles = {{BuiltInTile::arrows}};
    const StyledSurface surface{.mesh = mesh, .texture = texture};
    return draw_styled({surface}, styled_options(200, 200));
  };
  const Image still = shifted(0), half = shifted(0.5f), whole = shifted(1);
  int largest = 0;
  for (std::size_t p = 0; p < still.pixels.size(); ++p) {
    largest = std::max(largest, std::abs(still.pixels[p].red - whole.pixels[p].red));
  }
  EXPECT_LE(largest, 2);
  EXPECT_NE(still.pixels, half.pixels);
}

TEST(StyledPicture, DecalsFillTheShareOfTheirValue) {
  constexpr int kTiles = 6;
  const Mesh mesh = square(24);
  const TextureWaves waves = grid_waves(mesh, kTiles);
  std::vector<float> sizes;
  for (const Vec3& p : mesh.positions) sizes.push_back(p.y() < 0.5f ? kNaN : 0.2f + 0.8f * p.x());
  Image white(4, 4);
  std::ranges::fill(white.pixels, Pixel{255, 255, 255, 255});
  RegionTexture texture{.waves = &waves, .sizes = sizes};
  texture.tiles = {{white}};
  const Image image = draw_styled({{.mesh = mesh, .color = {0, 0, 0}, .texture = texture}},
                                  styled_options(480, 480));
  int left = 0;
  while (image.at(left, 240).alpha < 255) ++left;
  const double side = (480.0 - 2 * left) / kTiles;
  const auto share = [&](int column, int row) {
    double sum = 0, moment = 0;
    const int first = left + static_cast<int>(side * column), last = first + static_cast<int>(side);
    const int top = left + static_cast<int>(side * row);
    for (int y = top; y < top + static_cast<int>(side); ++y) {
      for (int x = first; x < last; ++x) {
        const double light = linear_light({static_cast<float>(image.at(x, y).red) / 255, 0, 0})[0];
        sum += light;
        moment += light * (x + 0.5 - 0.5 * (first + last));
      }
    }
    EXPECT_LT(std::abs(moment), 1.0 * sum + 1e-6) << column;  // within a pixel of the middle
    return sum / (side * side);
  };
  for (int column = 0; column < kTiles; ++column) {
    const double size = 0.2 + 0.8 * (column + 0.5) / kTiles;
    EXPECT_NEAR(std::sqrt(share(column, 1)), size, 0.05 * size) << column;
    EXPECT_EQ(share(column, kTiles - 2), 0) << column;
  }
}

TEST(StyledPicture, OcclusionDarkensHollowsAndNothingElse) {
  Mesh fold = square(16);
  for (Vec3& p : fold.positions) p.z() = std::abs(p.x() - 0.5f);
  const StyledSurface surface{.mesh = fold, .color = {0.7f, 0.7f, 0.7f}};
  StyledOptions options = styled_options(200, 200);
  const Image open = draw_styled({surface}, options);
  options.occlusion = 1;
  const Image closed = draw_styled({surface}, options);
  const auto light = [](const Image& image, int first, int last) {
    double sum = 0;
    for (int y = 90; y < 110; ++y) {
      for (int x = first; x < last; ++x) sum += image.at(x, y).red;
    }
    return sum / (20 * (last - first));
  };
  EXPECT_LT(light(closed, 96, 104), 0.8 * light(open, 96, 104));
  EXPECT_GT(light(closed, 35, 45), 0.97 * light(open, 35, 45));
}

TEST(StyledPicture, HollowsAreAsDarkWhereThePictureIsDrawnInParts) {
  Mesh fold = square(16);
  for (Vec3& p : fold.positions) p.z() = std::abs(p.x() + 0.3f * p.y() - 0.65f);
  const StyledSurface surface{.mesh = fold, .color = {0.7f, 0.7f, 0.7f}};
  StyledOptions options = styled_options(200, 200);
  options.occlusion = 1;
  const Image whole = draw_styled({surface}, options);
  options.render.tile_side = 150;  // parts of 28 rows
  const Image in_parts = draw_styled({surface}, options);
  for (int y = 0; y < whole.height; ++y) {
    double difference = 0;
    for (int x = 0; x < whole.width; ++x) {
      difference += std::abs(whole.at(x, y).red - in_parts.at(x, y).red);
    }
    EXPECT_LT(difference / whole.width, 0.2) << y;
  }
}

TEST(StyledPicture, TheShadowLiesOnTheGroundAlone) {
  Mesh table = square(8);
  for (Vec3& p : table.positions) p = Vec3(p.x(), 0.4f, p.y());
  // A leg down to the ground.
  const Mesh leg = square(1);
  Mesh thin = leg;
  for (Vec3& p : thin.positions) p = Vec3(0.5f + 0.02f * p.x(), 0.4f * p.y(), 0.5f);
  const std::vector<StyledSurface> surfaces{{.mesh = table}, {.mesh = thin}};
  StyledOptions options = styled_options(200, 150);
  options.render.camera.elevation_deg = 25;
  const Image without = draw_styled(surfaces, options);
  options.ground_shadow = true;
  const Image with = draw_styled(surfaces, options);
  int shadow = 0;
  for (std::size_t p = 0; p < with.pixels.size(); ++p) {
    if (without.pixels[p].alpha == 255) {
      EXPECT_EQ(with.pixels[p], without.pixels[p]);
    } else if (with.pixels[p].alpha > without.pixels[p].alpha + 8) {
      ++shadow;
      if (without.pixels[p].alpha == 0) {
        EXPECT_LE(with.pixels[p].red, 1);
      }
    }
  }
  EXPECT_GT(shadow, 500);
  options.render.camera.elevation_deg = -25;  // from below there is none
  const Image below = draw_styled(surfaces, options);
  options.ground_shadow = false;
  EXPECT_EQ(below.pixels, draw_styled(surfaces, options).pixels);
}

TEST(StyledPicture, NearIsRedAndFarIsBlue) {
  Mesh near = square(2), far = square(2);
  for (Vec3& p : far.positions) p += Vec3(0.6f, 0, -1.5f);
  for (Vec3& p : near.positions) p -= Vec3(0.6f, 0, 0);
  StyledOptions options = styled_options(200, 100);
  options.depth_cue = DepthCue::chroma;
  const Image image = draw_styled({{.mesh = near}, {.mesh = far}}, options);
  const Pixel left = image.at(60, 50), right = image.at(140, 50);
  EXPECT_GT(left.red, left.blue + 60);
  EXPECT_GT(right.blue, right.red + 60);
}

TEST(StyledPicture, TonesTaperStrokes) {
  // A sphere is lit from the upper left: strokes end there.
  StripedSurface s = plane_wave(make_shape("sphere,resolution=24"), Vec3::UnitX(), 6);
  std::vector<Vec3> normals = s.mesh.positions;
  StyledSurface surface{.mesh = s.mesh,
                        .normals = normals,
                        .color = {0, 0, 0},
                        .strokes = {strokes_of(s)},
                        .shading = false};
  surface.strokes[0].tone = ToneRange{0.8f, 0.3f};
  const Image image = draw_styled({surface}, styled_options(240, 240));
  const auto light = [&](int x, int y) {
    double sum = 0;
    for (int dy = -14; dy <= 14; ++dy) {
      for (int dx = -14; dx <= 14; ++dx) sum += image.at(x + dx, y + dy).red;
    }
    return sum / (29 * 29 * 255);
  };
  EXPECT_LT(light(85, 80), 0.02);
  EXPECT_GT(light(165, 185), 0.05 + 3 * light(85, 80));
}

/// A renderer that has the first surfaces, then `changed` in place of the one of that number.
Image draw_updated(const std::vector<StyledSurface>& first, std::size_t number,
                   const StyledSurface& changed, const StyledOptions& options) {
  Studio::shared();
  static StyledRenderer renderer;
  renderer.upload(first);
  renderer.update(number, changed);
  return renderer.draw(options);
}

TEST(StyledPicture, DepthCuesLeaveUntintedSurfacesAsTheyAre) {
  const Mesh first = square(2);
  Mesh far = square(2);
  for (Vec3& p : far.positions) p += Vec3(0.6f, 0, -1.5f);
  StyledOptions options = styled_options(200, 100);
  const std::vector<StyledSurface> plain = {{.mesh = first}, {.mesh = far}};
  std::vector<StyledSurface> spared = plain;
  spared[1].tinted = false;
  const Pixel own = draw_styled(plain, options).at(140, 50);
  for (const DepthCue cue : {DepthCue::chroma, DepthCue::haze}) {
    options.depth_cue = cue;
    EXPECT_EQ(draw_styled(spared, options).at(140, 50), own);
    EXPECT_NE(draw_styled(plain, options).at(140, 50), own);
    // So it is where a surface is replaced alone.
    EXPECT_EQ(draw_updated(plain, 1, spared[1], options).pixels,
              draw_styled(spared, options).pixels);
  }
}

TEST(StyledPicture, IsCancelledBetweenSurfacesAndDrawnAsEverThen) {
  const Sheets sheets;
  const std::vector<StyledSurface> surfaces{
      {.mesh = sheets.front.mesh,
       .strokes = {strokes_of(sheets.front)},
       .between = BetweenStrokes::discarded},
      {.mesh = sheets.back.mesh, .strokes = {strokes_of(sheets.back)}}};
  const StyledOptions options = styled_options();
  const HeadlessContext context;
  StyledRenderer renderer;
  renderer.upload(surfaces);
  testing_support::Reports all;
  const Image whole = renderer.draw(options, all.progress());
  EXPECT_GE(all.count(), 4) << "two surfaces are seen and lit one after the other";
  for (const int report : testing_support::reports_to_cancel(all.count())) {
    testing_support::Reports reports(report);
    EXPECT_THROW(renderer.draw(options, reports.progress()), Cancelled);
    EXPECT_EQ(renderer.draw(options).pixels, whole.pixels);
  }
}

TEST(StyledPicture, UpdatedSurfacesLookAsIfUploaded) {
  const Sheets sheets;
  StripedSurface moved = sheets.front;
  for (Vec3& p : moved.mesh.positions) p += Vec3(0.2f, 0.1f, 0);
  moved.waves.positions = moved.mesh.positions;
  const StripedSurface finer = plane_wave(square(5), Vec3(1, 1, 0).normalized(), 4);
  const StyledSurface behind{
      .mesh = sheets.back.mesh, .color = {0.2f, 0.5f, 0.3f}, .strokes = {strokes_of(sheets.back)}};
  const auto of = [&](const StripedSurface& s, BetweenStrokes between) {
    return StyledSurface{.mesh = s.mesh, .strokes = {strokes_of(s)}, .between = between};
  };
  const StyledOptions options = styled_options();
  for (const BetweenStrokes between : {BetweenStrokes::surface, BetweenStrokes::discarded}) {
    const std::vector<StyledSurface> first{of(sheets.front, between), behind};
    for (const StripedSurface& s : {moved, finer}) {
      const StyledSurface next = of(s, between);
      const Image uploaded = draw_styled({next, behind}, options);
      EXPECT_EQ(draw_updated(first, 0, next, options).pixels, uploaded.pixels);
      EXPECT_NE(draw_styled(first, options).pixels, uploaded.pixels);
    }
    const StyledSurface plain{.mesh = finer.mesh};
    EXPECT_EQ(draw_updated(first, 1, plain, options).pixels,
              draw_styled({first[0], plain}, options).pixels);
  }
  StyledRenderer renderer;
  renderer.upload(std::vector{behind});
  EXPECT_THROW(renderer.update(1, behind), Error);
  const Image before = renderer.draw(options);
  const std::vector<float> few(2, 0.5f);
  StyledSurface wrong = behind;
  wrong.color_places = few;
  EXPECT_THROW(renderer.update(0, wrong), Error);
  EXPECT_EQ(renderer.draw(options).pixels, before.pixels);
}

TEST(StyledPicture, TheCameraFramesWhatItIsTold) {
  const Mesh mesh = square(4);
  Mesh moved = mesh;
  for (Vec3& p : moved.positions) p += Vec3(0.5f, 0, 0);
  const std::vector<StyledSurface> one{{.mesh = mesh}}, other{{.mesh = moved}};
  StyledOptions options = styled_options();
  const Image own = draw_styled(one, options);
  EXPECT_EQ(draw_styled(other, options).pixels, own.pixels);
  const std::vector<Vec3> framed = framed_points(one);
  options.framed = framed;
  EXPECT_EQ(draw_styled(one, options).pixels, own.pixels);
  EXPECT_NE(draw_styled(other, options).pixels, own.pixels);
  EXPECT_EQ(eye_of(styled_camera(other, options)), eye_of(styled_camera(one, options)));
}

TEST(StyledPicture, WhatDoesNotFitIsRefused) {
  const StripedSurface s = plane_wave(square(2), Vec3::UnitX(), 3);
  const std::vector<float> few(2, 0.5f);
  const auto refused = [&](auto&& change) {
    StyledSurface surface{.mesh = s.mesh, .strokes = {strokes_of(s)}};
    change(surface);
    StyledRenderer renderer;
    EXPECT_THROW(renderer.upload(std::vector{surface}), Error);
  };
  Studio::shared();
  refused([&](StyledSurface& surface) { surface.strokes[0].widths = few; });
  refused([&](StyledSurface& surface) { surface.strokes[0].color_places = few; });
  refused([&](StyledSurface& surface) { surface.color_places = few; });
  refused([&](StyledSurface& surface) { surface.strokes[0].waves = nullptr; });
  refused([&](StyledSurface& surface) { surface.strokes[0].width = kNaN; });
  refused([&](StyledSurface& surface) { surface.strokes[0].opacity = 2; });
  refused([&](StyledSurface& surface) { surface.strokes[0].spacing = -1; });
  refused([&](StyledSurface& surface) { surface.strokes[0].tone = ToneRange{0.2f, 0.4f}; });
  refused([&](StyledSurface& surface) { surface.strokes.resize(3, surface.strokes[0]); });
  refused([&](StyledSurface& surface) {
    surface.strokes.clear();
    surface.between = BetweenStrokes::discarded;
  });
  refused([&](StyledSurface& surface) { surface.texture = RegionTexture(); });
  const TextureWaves waves = grid_waves(s.mesh, 2);
  refused([&](StyledSurface& surface) {
    surface.strokes.clear();
    surface.texture = RegionTexture{.waves = &waves, .tiles = {{BuiltInTile::dots}}, .sizes = few};
  });
  refused([&](StyledSurface& surface) {
    surface.strokes.clear();
    surface.texture = RegionTexture();
  });
  StyledRenderer renderer;
  EXPECT_THROW(renderer.upload({}), Error);
  StyledOptions options;
  options.occlusion = 2;
  EXPECT_THROW(renderer.draw(options), Error);
  options.occlusion = 0;
  options.right_margin = options.render.width;
  EXPECT_THROW(renderer.draw(options), Error);
}

}  // namespace
}  // namespace brindle
