#include <algorithm>

#include <gtest/gtest.h>

#include "session/live_picture.h"

namespace brindle::tool {
namespace {

struct Seen {
  ViewLegend legend;
  Image image;
};

Seen seen(SessionDocument document) {
  document.mesh = "shape:sphere,resolution=20";
  document.size = {240, 240};
  document.options["stripes"] = {"16"};
  LivePattern pattern;
  pattern.update(document, Follow::afresh);
  return {view_legend(*pattern.state()),
          LivePicture().draw(pattern.state(), PictureQuality::final)};
}

/// Whether a picture has pixels nearly of this colour, whatever light falls on them.
bool shows(const Image& image, const Color& color) {
  return std::ranges::any_of(image.pixels, [&](const Pixel& pixel) {
    const auto near = [](std::uint8_t seen, float meant) {
      return std::abs(static_cast<float>(seen) - 255 * meant) < 25;
    };
    return near(pixel.red, color.red) && near(pixel.green, color.green) &&
           near(pixel.blue, color.blue);
  });
}

TEST(ViewLegend, ExplainsTheColoursThatAreThere) {
  SessionDocument branches, errors, curves;
  branches.options["view"] = {"branches"};
  errors.options["view"] = {"angle_error"};
  curves.shown = Shown::curves;
  curves.curves = {{"lines", {"both"}}, {"tube-radius", {"1%"}}};
  const Seen plain = seen({});
  EXPECT_TRUE(plain.legend.empty());
  for (const SessionDocument& document : {branches, curves}) {
    const Seen coloured = seen(document);
    ASSERT_EQ(coloured.legend.entries.size(), 2u);
    for (const ViewLegend::Entry& entry : coloured.legend.entries) {
      EXPECT_TRUE(shows(coloured.image, entry.color)) << entry.meaning;
    }
  }
  const ViewLegend scale = seen(errors).legend;
  ASSERT_FALSE(scale.scale.empty());
  EXPECT_EQ(scale.lowest, "0");
  EXPECT_EQ(scale.highest.substr(0, 3), "30 ");
}

TEST(ViewLegend, OfOneColourThereIsNone) {
  SessionDocument curves, samples, values;
  curves.shown = Shown::curves;
  samples.shown = Shown::samples;
  values.options["color-by"] = {"height"};  // has one within the picture
  for (const SessionDocument& document : {curves, samples, values}) {
    EXPECT_TRUE(seen(document).legend.empty());
  }
}

}  // namespace
}  // namespace brindle::tool
