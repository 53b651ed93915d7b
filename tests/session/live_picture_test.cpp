#include "session/live_picture.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace brindle::tool {
namespace {

SessionDocument document_of(OptionValues options, PictureSize size) {
  SessionDocument document;
  document.mesh = "shape:torus,resolution=24";
  document.options = std::move(options);
  document.size = size;
  return document;
}

// Only what has changed is copied to OpenGL.
TEST(LivePicture, OfATextureThatMovesIsAsOneThatIsUploadedAnew) {
  const OptionValues dots{{"texture", {"dots"}}};
  OptionValues cut = dots, cross{{"texture", {"checker"}}, {"cross", {}}};
  cut["tiles"] = {"cut"};
  for (const OptionValues& options : {dots, cut, cross}) {
    SessionDocument document = document_of(options, {160, 120});
    LivePattern pattern;
    LivePicture moved;
    Image last(1, 1);
    for (const char* stripes : {"12", "13.5", "15"}) {
      document.options["stripes"] = {stripes};
      pattern.update(document, Follow::loosely);
      const Image image = moved.draw(pattern.state(), PictureQuality::interactive);
      const Image anew = LivePicture().draw(pattern.state(), PictureQuality::interactive);
      EXPECT_EQ(image.pixels, anew.pixels) << stripes;
      EXPECT_NE(image.pixels, last.pixels) << stripes;
      last = image;
    }
  }
}

bool is_line(const Image& image, int x, int y) {
  const Pixel& pixel = image.at(x, y);
  return std::max({pixel.red, pixel.green, pixel.blue}) < 90;
}

bool is_near_line(const Image& image, int x, int y) {
  for (int v = std::max(0, y - 2); v <= std::min(image.height - 1, y + 2); ++v) {
    for (int u = std::max(0, x - 2); u <= std::min(image.width - 1, x + 2); ++u) {
      if (is_line(image, u, v)) return true;
    }
  }
  return false;
}

/// Of the pixels that lines cover in one picture, the share that have one nearby in the other.
double share_near(const Image& lines, const Image& other) {
  int all = 0, near = 0;
  for (int y = 0; y < lines.height; ++y) {
    for (int x = 0; x < lines.width; ++x) {
      if (!is_line(lines, x, y)) continue;
      ++all;
      near += is_near_line(other, x, y);
    }
  }
  EXPECT_GT(all, 500);
  return static_cast<double>(near) / all;
}

// Drafts are smaller, but lines are as wide as in final pictures, and where they are there.
TEST(LivePicture, OutlinesOfDraftsAreThoseOfFinalPictures) {
  SessionDocument document = document_of(
      {{"stripes", {"12"}}, {"colors", {"#ffffff,#ffffff,#ffffff"}}, {"outline", {"solid"}}},
      {480, 360});
  document.mesh = "shape:torus,resolution=80";
  LivePattern pattern;
  pattern.update(document, Follow::afresh);
  LivePicture picture;
  const Image draft = picture.draft(pattern.state(), 1e4);
  const Image coarser = picture.draft(pattern.state());
  const Image final = picture.draw(pattern.state(), PictureQuality::final);
  EXPECT_NE(draft.pixels, coarser.pixels);
  for (const Image& image : {draft, coarser}) {
    EXPECT_GT(share_near(final, image), 0.95);
    EXPECT_GT(share_near(image, final), 0.95);
  }
}

}  // namespace
}  // namespace brindle::tool
