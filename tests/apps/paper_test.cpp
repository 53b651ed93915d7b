/// Sizes on paper: millimetres of drawings and pictures, and their scale.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>
#include <string>
#include <vector>

#include "tool.h"

#ifdef BRINDLE_HAS_GL

#include "brindle/image.h"

namespace brindle::test {
namespace {

using Arguments = std::vector<std::string>;

constexpr double kPixel = 25.4 / 96;  ///< millimetres

/// The extent of a drawing's pen in millimetres.
Eigen::Vector2d extent_of(const std::string& svg, const std::string& pen) {
  const std::size_t begin = svg.find("<g id=\"" + pen);
  EXPECT_NE(begin, std::string::npos) << pen;
  const std::string group = svg.substr(begin, svg.find("</g>", begin) - begin);
  const std::regex point(R"([ML ](-?[0-9.]+) (-?[0-9.]+))");
  Eigen::AlignedBox2d box;
  for (std::sregex_iterator at(group.begin(), group.end(), point), end; at != end; ++at) {
    box.extend(Eigen::Vector2d(std::stod((*at)[1]), std::stod((*at)[2])));
  }
  return kPixel * box.sizes();
}

struct PaperTool : ToolTest {
  std::string drawn(const Arguments& more) const {
    Arguments words = {"curves",   "shape:plane,width=60,height=40,resolution=24",
                       "--camera", "top,orthographic",
                       "--output", "a.svg",
                       "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const ToolResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return content(folder / "a.svg");
  }
};

TEST_F(PaperTool, DrawingsHaveTheScaleThatIsAsked) {
  constexpr double kAccuracy = 0.02;  // of strokes, millimetres
  for (const auto& [scale, factor] : {std::pair("1:1", 1.0), {"1:2", 0.5}, {"2:1", 2.0}}) {
    for (const char* size : {"297mmx210mm", "601x407"}) {
      const Eigen::Vector2d extent =
          extent_of(drawn({"--scale", scale, "--size", size}), "outline");
      EXPECT_NEAR(extent.x(), 60 * factor, kAccuracy) << scale << ' ' << size;
      EXPECT_NEAR(extent.y(), 40 * factor, kAccuracy) << scale << ' ' << size;
    }
  }
}

TEST_F(PaperTool, OutlinesOfStripesHaveTheScale) {
  const ToolResult result =
      run({"stripe", "shape:box,width=10,depth=8,height=6,hole=0,resolution=8", "--camera",
           "front,orthographic", "--scale", "5:1", "--size", "20cmx10cm", "--outline", "solid",
           "--stripe-width", "0", "--output", "a.svg", "--quiet"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const Eigen::Vector2d extent = extent_of(content(folder / "a.svg"), "lines");
  EXPECT_NEAR(extent.x(), 50, 0.05);
  EXPECT_NEAR(extent.y(), 30, 0.05);
}

TEST_F(PaperTool, DrawingsHaveTheSizeOfThePage) {
  for (const auto& [size, header] :
       {std::pair("297mmx210mm",
                  R"(width="297mm" height="210mm" viewBox="0 0 1122.51969 793.700787")"),
        {"11inx8.5in", R"(width="279.4mm" height="215.9mm" viewBox="0 0 1056 816")"},
        {"29.7cmx21cm", R"(width="297mm" height="210mm")"},
        {"400x300", R"(width="400" height="300" viewBox="0 0 400 300")"}}) {
    const std::string svg = drawn({"--size", size});
    EXPECT_TRUE(has(svg, header)) << svg.substr(0, 200);
  }
}

TEST_F(PaperTool, PagesOfPdfHaveTheSize) {
  if (!has(run({"--version"}).out, "Cairo")) GTEST_SKIP() << "this build writes no .pdf";
  drawn({"--size", "297mmx210mm", "--output", "a.pdf"});
  EXPECT_TRUE(has(content(folder / "a.pdf"), "MediaBox [ 0 0 841.88976")) << "72 points an inch";
}

TEST_F(PaperTool, PicturesHaveTheScaleInPixels) {
  const ToolResult result =
      run({"stripe", "shape:plane,width=60,height=40,resolution=24", "--camera", "top,orthographic",
           "--scale", "1:1", "--size", "80mmx50mm", "--dpi", "254", "--stripe-width", "0",
           "--transparent", "--output", "a.png", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Image image = read_png(folder / "a.png");
  EXPECT_EQ(image.width, 800);
  EXPECT_EQ(image.height, 500);
  Eigen::AlignedBox2i box;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.at(x, y).alpha > 127) box.extend(Eigen::Vector2i(x, y));
    }
  }
  EXPECT_EQ((box.sizes() + Eigen::Vector2i(1, 1)).transpose(), Eigen::RowVector2i(600, 400));
  EXPECT_TRUE(
      has(content(folder / "a.png"), std::string_view("pHYs\0\0\x27\x10\0\0\x27\x10\1", 13)))
      << "10,000 pixels in a metre";
}

TEST_F(PaperTool, RefusesWhatGivesNoScale) {
  const auto refuses = [this](std::string_view message, const Arguments& more,
                              const char* file = "a.svg") {
    Arguments words = {"curves", "shape:plane", "--output", file};
    words.insert(words.end(), more.begin(), more.end());
    expect_refusal(2, message, words);
  };
  refuses("add ',orthographic' to --camera", {"--scale", "1:1"});
  refuses("--scale: a picture in perspective has no scale",
          {"--scale", "1:1", "--camera", "30,20,perspective"});
  refuses("--scale: the zoom of --camera gives another scale",
          {"--scale", "1:1", "--camera", "top,2,orthographic"});
  for (const char* scale : {"1", "1:0", "0:1", "-1:1", "-1:-1", "1:1:1", "one:1", "1:inf", ":"}) {
    refuses("--scale: expected MM:UNITS", {"--scale", scale, "--camera", "30,20,orthographic"});
  }
  for (const char* size : {"297mm", "297mmx210", "0mmx9mm", "nanmmx9mm", "-1mmx9mm", "9ftx9ft"}) {
    refuses("--size: expected WIDTHxHEIGHT in pixels, or both in mm, cm or in", {"--size", size});
  }
  refuses("--size: a picture of 1000000 x ", {"--size", "1e9mmx9mm"});
  refuses("--size: a .png has pixels; add --dpi", {"--size", "90mmx60mm"}, "a.png");
  refuses("--scale: a .png has pixels; add --dpi",
          {"--scale", "1:1", "--camera", "30,20,orthographic"}, "a.png");
  refuses("--dpi: has no effect here: it is for pixels", {"--dpi", "300"});
  refuses("--dpi: a drawing has 96 pixels an inch",
          {"--size", "90mmx60mm", "--dpi", "300", "--output", "a.png"});
  expect_refusal(2, "--size: expected WIDTHxHEIGHT in pixels, got",
                 {"animate", kTorus16, "--size", "90mmx60mm", "--output", "a%d.png"});
}

TEST_F(PaperTool, RefusesASurfaceBeyondThePage) {
  expect_refusal(
      1, "at this scale the surface is 2.01 times as large as the picture",
      {"curves", "shape:plane,width=60,height=40,resolution=24", "--camera", "top,orthographic",
       "--scale", "2:1", "--size", "100mmx40mm", "--output", "a.svg", "--quiet"});
}

}  // namespace
}  // namespace brindle::test

#endif
