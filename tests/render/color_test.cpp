#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/image.h"
#include "brindle/render/color_names.h"
#include "brindle/render/parsed_words.h"

namespace brindle {
namespace {

TEST(Color, IsReadFromText) {
  EXPECT_EQ(parse_color("#ff0080"), (Color{1, 0, 128 / 255.0f}));
  EXPECT_EQ(parse_color("fff"), (Color{1, 1, 1}));
  EXPECT_EQ(parse_color("steelblue"), parse_color("#4682b4"));
  EXPECT_EQ(parse_color("SteelBlue"), parse_color("steelblue"));
  EXPECT_EQ(parse_color("red"), (Color{1, 0, 0}));
  for (const char* text :
       {"", "#", "reddish", "#red", "re", "#12345", "#1234567", "#gg0000", "#-10000"}) {
    EXPECT_FALSE(parse_color(text)) << text;
  }
}

TEST(Color, EveryNameIsFound) {
  for (const ColorName& named : kColorNames) {
    const auto color = parse_color(named.name);
    ASSERT_TRUE(color) << named.name;
    EXPECT_EQ(std::lround(255 * color->red) << 16 | std::lround(255 * color->green) << 8 |
                  std::lround(255 * color->blue),
              named.rgb)
        << named.name;
  }
}

TEST(Color, LightOfWhiteGreyAndBlack) {
  EXPECT_TRUE(linear_light({1, 1, 1}).isApprox(Vec3::Ones()));
  EXPECT_EQ(linear_light({0, 0, 0}), Vec3::Zero());
  EXPECT_NEAR(linear_light({0.5f, 0, 0})[0], 0.2140f, 1e-4);  // IEC 61966-2-1
}

TEST(ErrorColor, DarkensSteadily) {
  float last = 2;
  for (int i = 0; i <= 100; ++i) {
    const Vec3 light = linear_light(error_color(static_cast<float>(i) / 100));
    const float luminance = light.dot(Vec3(0.2126f, 0.7152f, 0.0722f));
    EXPECT_LT(luminance, last);
    last = luminance;
  }
  EXPECT_LT(last, 0.05f);
}

TEST(ErrorColor, ClampsWhatIsOutside) {
  EXPECT_EQ(error_color(-3), error_color(0));
  EXPECT_EQ(error_color(7), error_color(1));
  EXPECT_EQ(error_color(std::numeric_limits<float>::quiet_NaN()), error_color(0));
}

}  // namespace
}  // namespace brindle
