/// Drawings beside pictures of the same view, as somebody else's program shows them: librsvg's.
#include <cstdlib>
#include <string>
#include <vector>

#include "tool.h"

#ifdef BRINDLE_HAS_GL

#include "brindle/image.h"
#include "brindle/renderer.h"

namespace brindle::test {
namespace {

using Arguments = std::vector<std::string>;

struct DrawingTool : ToolTest {
  void SetUp() override {
    ToolTest::SetUp();
    if (std::system("command -v rsvg-convert >/dev/null") != 0) {
      GTEST_SKIP() << "there is no rsvg-convert; install librsvg2-bin";
    }
  }

  /// The share of pixels where the drawing and the flat picture of the same words differ by more
  /// than half a level: of black marks on a white surface before nothing.
  double differing_share(const Arguments& words) const {
    Arguments drawn = {"stripe", "--colors", "black,white", "--quiet"};
    drawn.insert(drawn.end(), words.begin(), words.end());
    Arguments painted = drawn;
    drawn.insert(drawn.end(), {"--output", "a.svg"});
    painted.insert(painted.end(), {"--flat", "--transparent", "--output", "a.png"});
    const ToolResult drawing = run(drawn), picture = run(painted);
    EXPECT_EQ(drawing.exit_code, 0) << drawing.err;
    EXPECT_EQ(picture.exit_code, 0) << picture.err;
    const std::string convert = "rsvg-convert '" + (folder / "a.svg").string() + "' -o '" +
                                (folder / "b.png").string() + "'";
    EXPECT_EQ(std::system(convert.c_str()), 0);
    return differing_share(read_png(folder / "a.png"), read_png(folder / "b.png"));
  }

  static double differing_share(const Image& a, const Image& b) {
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    if (a.pixels.size() != b.pixels.size()) return 1;
    std::size_t differing = 0, dark = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      const Eigen::Vector4f left = premultiplied_light(a.pixels[i]);
      const Eigen::Vector4f right = premultiplied_light(b.pixels[i]);
      differing += (left - right).cwiseAbs().maxCoeff() > 0.5f;
      dark += left.x() < 0.5f && left.w() > 0.5f;
    }
    EXPECT_GT(dark, a.pixels.size() / 50);
    return static_cast<double>(differing) / static_cast<double>(a.pixels.size());
  }
};

TEST_F(DrawingTool, OfStripesAreTheirPictures) {
  EXPECT_LT(differing_share({"shape:trefoil", "--field", "curvature", "--size", "400x300"}), 0.01);
  EXPECT_LT(differing_share({"shape:torus", "--width-by", "height", "--size", "400x300"}), 0.01);
  EXPECT_LT(differing_share({"shape:vessels,resolution=60", "--between", "nothing", "--stripes",
                             "30", "--size", "400x300"}),
            0.01);
}

TEST_F(DrawingTool, OfTilesAreTheirPictures) {
  for (const char* tile : {"arrows", "bricks"}) {
    EXPECT_LT(differing_share({"shape:torus", "--texture", tile, "--stripes", "16", "--camera",
                               "30,50", "--size", "320x240"}),
              0.01)
        << tile;
  }
  EXPECT_LT(
      differing_share({"shape:torus", "--texture", "dots", "--texture-by",
                       "height,regions=0,plus@#000000", "--stripes", "16", "--size", "320x240"}),
      0.01);
}

}  // namespace
}  // namespace brindle::test

#endif
