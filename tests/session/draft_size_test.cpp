#include "session/draft_size.h"

#include <gtest/gtest.h>

#include "brindle/threads.h"

namespace brindle::tool {
namespace {

Image slope(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto at = [](int i, int n) { return static_cast<std::uint8_t>(255 * i / (n - 1)); };
      image.at(x, y) = {at(x, width), at(y, height), 90, 255};
    }
  }
  return image;
}

TEST(Enlarged, IsTheSameAtItsOwnSizeAndPlainWhereItWasPlain) {
  const Image image = slope(37, 23);
  EXPECT_EQ(enlarged(image, 37, 23).pixels, image.pixels);
  for (const Pixel& pixel : enlarged(image, 100, 61).pixels) {
    EXPECT_EQ(pixel.blue, 90);
    EXPECT_EQ(pixel.alpha, 255);
  }
  EXPECT_EQ(enlarged(Image(1, 1), 5, 3).pixels, Image(5, 3).pixels);
}

TEST(Enlarged, IsAsSteepAsBeforeAndMixesNothingNew) {
  const Image image = slope(40, 40);
  const Image large = enlarged(image, 120, 120);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 120; ++x) {
      const double across = std::clamp((x + 0.5) / 3 - 0.5, 0.0, 39.0);
      const double down = std::clamp((y + 0.5) / 3 - 0.5, 0.0, 39.0);
      EXPECT_NEAR(large.at(x, y).red, 255 * across / 39, 1.6);
      EXPECT_NEAR(large.at(x, y).green, 255 * down / 39, 1.6);
    }
  }
}

TEST(Enlarged, DoesNotDependOnTheNumberOfThreads) {
  const auto with_threads = [](int threads) {
    const ThreadLimit limit(threads);
    return enlarged(slope(50, 300), 75, 450).pixels;
  };
  EXPECT_EQ(with_threads(1), with_threads(3));
}

TEST(DraftSize, SettlesWhereDrawingIsFastEnoughAndStaysThere) {
  for (const double before : {0.0, 30.0, 200.0}) {
    for (const double whole : {5.0, 60.0, 130.0, 400.0, 5000.0}) {  // milliseconds at full size
      DraftSize size;
      const auto drawing = [&] { return whole / (size.reduction() * size.reduction()); };
      for (int frame = 0; frame < 5; ++frame) size.note(drawing(), before);
      const float settled = size.reduction();
      for (int frame = 0; frame < 5; ++frame) {
        size.note(drawing(), before);
        EXPECT_EQ(size.reduction(), settled) << whole << " after " << before;
      }
      EXPECT_TRUE(before + drawing() <= 60 || settled == 4) << whole << " after " << before;
      EXPECT_TRUE(settled == 1 || before + whole > 46) << whole << " after " << before;
    }
  }
}

}  // namespace
}  // namespace brindle::tool
