#include <limits>

#include <gtest/gtest.h>

#include "brindle/image.h"
#include "brindle/render/parsed_words.h"

namespace brindle {
namespace {

/// CIE lightness, 0 to 100: equal steps look equal.
float lightness(const Color& color) {
  const float light = linear_light(color).dot(Vec3(0.2126f, 0.7152f, 0.0722f));
  return light > 0.008856f ? 116 * std::cbrt(light) - 16 : 903.3f * light;
}

TEST(ColorMap, NamesAreReadBack) {
  EXPECT_EQ(parse_color_map("viridis"), ColorMap::viridis);
  EXPECT_EQ(parse_color_map("magma"), ColorMap::magma);
  EXPECT_EQ(parse_color_map("cividis"), ColorMap::cividis);
  EXPECT_EQ(parse_color_map("coolwarm"), ColorMap::coolwarm);
  EXPECT_FALSE(parse_color_map("jet"));
  EXPECT_FALSE(parse_color_map(""));
}

TEST(ColorMap, SequentialMapsGrowLighterInEvenSteps) {
  for (const ColorMap map : {ColorMap::viridis, ColorMap::magma, ColorMap::cividis}) {
    constexpr int kSteps = 50;
    const float mean = (lightness(map_color(map, 1)) - lightness(map_color(map, 0))) / kSteps;
    EXPECT_GT(mean * kSteps, 70);
    for (int i = 1; i <= kSteps; ++i) {
      const float step = lightness(map_color(map, static_cast<float>(i) / kSteps)) -
                         lightness(map_color(map, static_cast<float>(i - 1) / kSteps));
      EXPECT_GT(step, 0.3f * mean) << i;
      EXPECT_LT(step, 1.7f * mean) << i;
    }
  }
}

TEST(ColorMap, CoolwarmIsLightestInTheMiddleAndFallsAlikeOnBothSides) {
  const auto at = [](float place) { return lightness(map_color(ColorMap::coolwarm, place)); };
  for (float away = 0; away < 0.5f; away += 0.1f) {
    EXPECT_GT(at(0.5f + away), at(0.6f + away));
    EXPECT_GT(at(0.5f - away), at(0.4f - away));
    EXPECT_NEAR(at(0.5f - away), at(0.5f + away), 9);
  }
}

TEST(ColorMap, BeyondTheEndsAreTheEnds) {
  const Color first = map_color(ColorMap::magma, 0), last = map_color(ColorMap::magma, 1);
  EXPECT_EQ(map_color(ColorMap::magma, -3), first);
  EXPECT_EQ(map_color(ColorMap::magma, 7), last);
  EXPECT_EQ(map_color(ColorMap::magma, std::numeric_limits<float>::quiet_NaN()), first);
  EXPECT_NEAR(map_color(ColorMap::viridis, 0).red, 0x44 / 255.0f, 1e-6f);
  EXPECT_NEAR(map_color(ColorMap::viridis, 1).blue, 0x25 / 255.0f, 1e-6f);
}

}  // namespace
}  // namespace brindle
