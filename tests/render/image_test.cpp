#include "brindle/image.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "progress_reports.h"
#include "test_folder.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

struct ImageFile : TestFolder {
  static Image picture(bool transparent) {
    Image image(7, 5);
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 7; ++x) {
        const auto value = static_cast<std::uint8_t>(30 * x + y);
        image.at(x, y) = {value, static_cast<std::uint8_t>(value + 1),
                          static_cast<std::uint8_t>(255 - value),
                          static_cast<std::uint8_t>(transparent ? 40 * y : 255)};
      }
    }
    return image;
  }
  static std::string message_of(const fs::path& path) {
    try {
      read_png(path);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(ImageFile, IsNotWrittenUnderAnotherName) {
  for (const char* name : {"a.jpg", "a.svg", "a"}) {
    try {
      write_png(folder / name, picture(false));
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("name it .png"), std::string::npos) << error.what();
    }
    EXPECT_FALSE(fs::exists(folder / name));
  }
  write_png(folder / "a.PNG", picture(false));
  EXPECT_EQ(read_png(folder / "a.PNG").pixels, picture(false).pixels);
}

TEST_F(ImageFile, ComesBackAsWritten) {
  for (const bool transparent : {false, true}) {
    const Image image = picture(transparent);
    write_png(folder / "a.png", image);
    const Image back = read_png(folder / "a.png");
    EXPECT_EQ(back.width, 7);
    EXPECT_EQ(back.height, 5);
    EXPECT_EQ(back.pixels, image.pixels);
  }
}

TEST_F(ImageFile, TruncatedFileIsNamed) {
  write_png(folder / "a.png", picture(false));
  fs::resize_file(folder / "a.png", fs::file_size(folder / "a.png") / 2);
  EXPECT_NE(message_of(folder / "a.png").find("a.png"), std::string::npos);
}

TEST_F(ImageFile, OtherFilesFoldersAndNothingAreNamed) {
  std::ofstream(folder / "text.png") << "no picture";
  for (const fs::path& path : {folder / "text.png", folder, folder / "none.png"}) {
    EXPECT_NE(message_of(path).find(path.string()), std::string::npos) << message_of(path);
  }
}

TEST_F(ImageFile, HugePictureIsRefusedBeforeItIsRead) {
  // The first 33 bytes of a PNG file of 200000 x 200000 pixels.
  const std::string header(
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\x03\x0d\x40\0\x03\x0d\x40\x08\x02\0\0\0"
      "\x2b\xe9\x1d\x34",
      33);
  std::ofstream(folder / "huge.png", std::ios::binary) << header;
  EXPECT_NE(message_of(folder / "huge.png").find("huge.png"), std::string::npos);
}

TEST(Image, SizesBeyondTheLimitsAreRefused) {
  EXPECT_THROW(Image(0, 5), Error);
  EXPECT_THROW(Image(5, -1), Error);
  EXPECT_THROW(Image(kMaxImageSide + 1, 1), Error);
  EXPECT_THROW(Image(kMaxImageSide, kMaxImageSide), Error);
}

/// A picture whose file is not small.
Image noise(int width, int height) {
  Image image(width, height);
  std::uint32_t x = 1;
  for (Pixel& pixel : image.pixels) {
    x = x * 1664525 + 1013904223;
    pixel = {static_cast<std::uint8_t>(x >> 8), static_cast<std::uint8_t>(x >> 16),
             static_cast<std::uint8_t>(x >> 24), 255};
  }
  return image;
}

// As in the PNG specification: a chunk between the header and the pixels, 9 bytes long, in pixels a
// metre.
TEST_F(ImageFile, SaysHowManyPixelsAreAnInch) {
  const Image image = noise(7, 5);
  const std::string plain = png_of(image), print = png_of(image, {}, 300);
  EXPECT_EQ(plain.find("pHYs"), plain.npos);
  ASSERT_EQ(print.size(), plain.size() + 21);
  const auto chunk = print.find("pHYs");
  ASSERT_EQ(chunk, 8u + 25 + 4);
  const std::string_view bytes = std::string_view(print).substr(chunk + 4, 13);
  const std::string density("\0\0\x2e\x23", 4);  // 11811
  EXPECT_EQ(bytes.substr(0, 9), density + density + "\1");
  EXPECT_EQ(bytes.substr(9), "\x78\xa5\x3f\x76");
  const fs::path path = folder / "print.png";
  write_png(path, image, {}, 300);
  EXPECT_EQ(read_png(path).pixels, image.pixels);
  EXPECT_THROW(png_of(image, {}, -1), Error);
  EXPECT_THROW(png_of(image, {}, std::numeric_limits<double>::quiet_NaN()), Error);
}

TEST_F(ImageFile, WritingCanBeCancelledAtEveryReportAndLeavesWhatWasThere) {
  const Image image = noise(300, 200);
  const fs::path path = folder / "noise.png";
  std::vector<double> fractions;
  write_png(path, image, Progress([&](const ProgressReport& report) {
              fractions.push_back(report.fraction);
              return true;
            }));
  EXPECT_GE(fractions.size(), 10u);  // 180 kB in pieces
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1);
  EXPECT_EQ(read_png(path).pixels, image.pixels);
  EXPECT_EQ(png_of(image), png_of(image, Progress([](std::string_view, double) { return true; })));
  for (int report = 0; report < static_cast<int>(fractions.size()); ++report) {
    testing_support::Reports reports(report);
    EXPECT_THROW(write_png(path, noise(301, 200), reports.progress()), Cancelled) << report;
  }
  EXPECT_EQ(read_png(path).pixels, image.pixels);
}

TEST(Image, EmptyPictureIsNotWritten) {
  EXPECT_THROW(write_png(fs::path(testing::TempDir()) / "empty.png", Image()), Error);
}

}  // namespace
}  // namespace brindle
