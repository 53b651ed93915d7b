#include "brindle/legend.h"

#include <algorithm>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/ink.h"
#include "brindle/render/stroke_font.h"

namespace brindle {
namespace {

Image white(int width, int height) {
  Image image(width, height);
  std::ranges::fill(image.pixels, Pixel{255, 255, 255, 255});
  return image;
}

double darkness(const Image& image) {
  double sum = 0;
  for (const Pixel& pixel : image.pixels) sum += 1 - linear_light({pixel.red / 255.0f, 0, 0})[0];
  return sum;
}

TEST(Legend, TicksAreRoundNumbersWithinTheEnds) {
  EXPECT_EQ(tick_values(0, 10, 6), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(tick_values(3, 3, 6), (std::vector<double>{3}));
  for (const auto& [lowest, highest] :
       {std::pair{-1.3, 2.7}, {1e-7, 3e-7}, {12345.0, 12399.0}, {-5e8, 7e8}}) {
    const std::vector<double> ticks = tick_values(lowest, highest, 6);
    EXPECT_GE(ticks.size(), 2u);
    EXPECT_LE(ticks.size(), 7u);
    EXPECT_GE(ticks.front(), lowest - 1e-6 * (highest - lowest));
    EXPECT_LE(ticks.back(), highest + 1e-6 * (highest - lowest));
    EXPECT_TRUE(std::ranges::is_sorted(ticks));
  }
}

TEST(Legend, StaysInItsMargin) {
  const std::vector<Legend> legends{{.title = "speed in m/s", .scale = ColorScale{}}};
  Image image = white(400, 300);
  const int margin = legend_width(legends, 400, 300);
  EXPECT_GT(margin, 40);
  EXPECT_LE(margin, 200);
  draw_legends(image, legends);
  const Image untouched = white(400, 300);
  int changed = 0;
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) {
      if (image.at(x, y) == untouched.at(x, y)) continue;
      ++changed;
      EXPECT_GE(x, 400 - margin);
    }
  }
  EXPECT_GT(changed, 500);
}

TEST(Legend, ShowsTheMapFromTheBottomToTheTopAndTheThreshold) {
  const ColorScale scale{ColorMap::viridis, 0.5f, {1, 0, 0}};
  const std::vector<Legend> legends{{.title = "", .scale = scale}};
  Image image = white(400, 300);
  draw_legends(image, legends);
  std::vector<Pixel> bar;
  for (int y = 0; y < 300; ++y) {
    const int x = 400 - legend_width(legends, 400, 300) + 20;
    if (image.at(x, y) != Pixel{255, 255, 255, 255}) bar.push_back(image.at(x, y));
  }
  ASSERT_GT(bar.size(), 50u);
  EXPECT_EQ(bar[5], (Pixel{255, 0, 0, 255}));
  const Color low = map_color(ColorMap::viridis, 2.5f / static_cast<float>(bar.size()));
  EXPECT_NEAR(bar[bar.size() - 3].red, 255 * low.red, 4);
  EXPECT_NEAR(bar[bar.size() - 3].blue, 255 * low.blue, 4);
}

// A threshold at the bar's end, or beyond it, has a colour that pictures show.
TEST(Legend, ShowsWhatIsBeyondTheBar) {
  const auto red = [](std::optional<float> threshold) {
    Legend legend{.title = "p", .lowest = 60, .highest = 220};
    legend.scale = ColorScale{ColorMap::viridis, threshold, {1, 0, 0}};
    Image image = white(400, 300);
    draw_legends(image, {legend});
    return std::ranges::count(image.pixels, Pixel{255, 0, 0, 255});
  };
  EXPECT_EQ(red(std::nullopt), 0);
  const auto beyond = red(1.0f);
  EXPECT_GT(beyond, 50);
  EXPECT_EQ(red(1.5f), beyond);
  EXPECT_GT(red(0.5f), 3 * beyond) << "half of the bar";
  Legend narrow{.title = "", .lowest = 0, .highest = 1, .scale = ColorScale{}};
  Legend wide = narrow;
  wide.scale->threshold = 1.0f;
  EXPECT_GT(legend_width({wide}, 400, 300), legend_width({narrow}, 400, 300))
      << "it says from where on";
}

TEST(Legend, WedgesAreAsWideAsTheirStrokes) {
  const auto area = [](float first, float last) {
    Image image = white(400, 300);
    Legend legend{.title = "", .widths = Eigen::Vector2f(first, last)};
    legend.ink = {0, 0, 0};
    draw_legends(image, {legend});
    return darkness(image);
  };
  const double labels = area(0, 0);
  EXPECT_NEAR(area(0, 1) - labels, area(1, 0) - labels, 0.02 * area(0, 1));
  EXPECT_NEAR(area(1, 1) - labels, 2 * (area(0, 1) - labels), 0.03 * area(1, 1));
}

TEST(Legend, NumbersThatAreNoneAreRefused) {
  Image image = white(64, 64);
  Legend legend;
  legend.highest = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(draw_legends(image, {legend}), Error);
  draw_legends(image, {});
  EXPECT_EQ(legend_width({}, 400, 300), 0);
}

TEST(StrokeFont, EveryLetterAndDigitLooksDifferent) {
  std::set<std::vector<std::vector<std::pair<float, float>>>> seen;
  const std::string letters =
      "0123456789ABCDEFGHIJKLMNPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz.,-+/()%";
  for (const char letter : letters) {
    std::vector<std::vector<std::pair<float, float>>> strokes;
    for (const Stroke& stroke : text_strokes(std::string(1, letter), {0, 0}, 8)) {
      auto& points = strokes.emplace_back();
      for (const auto& point : stroke) points.emplace_back(point.x(), point.y());
    }
    EXPECT_FALSE(strokes.empty()) << letter;
    EXPECT_TRUE(seen.insert(strokes).second) << letter;
  }
}

TEST(StrokeFont, TextIsAsWideAsItSays) {
  for (const char* text : {"speed", "0.25", "m/s", "µm²", "°C"}) {
    float right = 0;
    for (const Stroke& stroke : text_strokes(text, {0, 0}, 20)) {
      for (const auto& point : stroke) right = std::max(right, point.x());
    }
    EXPECT_NEAR(right, text_width(text, 20), 5.0f) << text;
    EXPECT_LE(right, text_width(text, 20) + 1e-3f) << text;
  }
  EXPECT_EQ(text_width("", 20), 0);
}

TEST(Ink, StrokesCoverAsMuchAsTheyAreWide) {
  for (const float width : {0.5f, 1.0f, 2.5f, 6.0f}) {
    Image image = white(100, 40);
    const std::vector<Stroke> strokes{{{10.0f, 20.3f}, {90.0f, 20.3f}}};
    ink(image, strokes, width, {0, 0, 0});
    double across = 0;
    for (int y = 0; y < 40; ++y)
      across += 1 - linear_light({image.at(50, y).red / 255.0f, 0, 0})[0];
    EXPECT_NEAR(across, width, 0.12 * width + 0.02);
  }
}

TEST(Ink, OnNothingStaysItself) {
  Image image(20, 20);
  std::ranges::fill(image.pixels, Pixel{0, 0, 0, 0});
  const std::vector<Stroke> strokes{{{2.0f, 10.0f}, {18.0f, 10.0f}}};
  ink(image, strokes, 4, {1, 0, 0});
  EXPECT_EQ(image.at(10, 10), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(image.at(10, 2), (Pixel{0, 0, 0, 0}));
}

}  // namespace
}  // namespace brindle
