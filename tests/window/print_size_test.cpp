#include "window/dialogs/print_size.h"

#include <limits>

#include <gtest/gtest.h>

namespace brindle::tool {
namespace {

TEST(PrintSizeTest, AnInchHasItsPixels) {
  const PrintSize inches{50.8, 25.4, true};
  EXPECT_EQ(pixels_of(inches, 300), (PictureSize{600, 300}));
  EXPECT_EQ(pixels_of(inches, 96), (PictureSize{192, 96}));
  EXPECT_EQ(pixels_of({600, 300}, 96), (PictureSize{600, 300})) << "pixels are what they are";
  EXPECT_EQ(in_pixels(inches, 300), (PrintSize{600, 300}));
}

TEST(PrintSizeTest, ThereAndBackIsTheSame) {
  for (const double dpi : {72.0, 96.0, 300.0, 1200.0}) {
    for (int side = 1; side < 5000; side += 37) {
      const PrintSize pixels{static_cast<double>(side), static_cast<double>(2 * side + 1)};
      EXPECT_EQ(in_pixels(in_millimetres(pixels, dpi), dpi), pixels) << dpi;
    }
  }
}

TEST(PrintSizeTest, KeepsProportions) {
  const PictureSize window{1200, 900};
  EXPECT_EQ(of_width(400, {1, 1}, window), (PrintSize{400, 300}));
  EXPECT_EQ(of_height(300, {1, 1}, window), (PrintSize{400, 300}));
  EXPECT_EQ(of_width(401, {1, 1}, window), (PrintSize{401, 301})) << "whole pixels";
  EXPECT_EQ(of_width(10, {1, 1, true}, window), (PrintSize{10, 7.5, true}));
}

TEST(PrintSizeTest, WhatNoPictureHasStaysOutOfRange) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(pixels_of({kInfinite, 5, true}, 300).width, 0);
  EXPECT_EQ(pixels_of({1e30, 25.4, true}, 300),
            (PictureSize{std::numeric_limits<int>::max(), 300}));
  EXPECT_LT(pixels_of({-1, 5}, 300).width, 0);
  EXPECT_EQ(pixels_of({25.4, 25.4, true}, 0), (PictureSize{0, 0}));
}

}  // namespace
}  // namespace brindle::tool
