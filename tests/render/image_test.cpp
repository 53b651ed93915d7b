#include "brindle/image.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "brindle/error.h"
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
    EXPECT_NE(message_of(path).find("cannot read '" + path.string()), std::string::npos);
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

TEST(Image, EmptyPictureIsNotWritten) {
  EXPECT_THROW(write_png(fs::path(testing::TempDir()) / "empty.png", Image()), Error);
}

}  // namespace
}  // namespace brindle
