// Frames in styles.
#include <filesystem>
#include <string>

#include "tool.h"
#include "vtp_text.h"

#ifdef BRINDLE_HAS_GL

#include "brindle/image.h"

namespace brindle::test {
namespace {

using Arguments = std::vector<std::string>;

struct AnimateStyle : ToolTest {
  Image picture(const std::string& name) { return read_png(folder / name); }
  void expect_run(Arguments arguments, const Arguments& more = {}) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(), {"--size", "96x72", "-q"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  /// A square whose array has this number everywhere, and another one that grows.
  void write_step(const std::string& name, double number) {
    TextMesh mesh;
    TextArray same{"same", 1, {}}, growing{"growing", 1, {}};
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 3; ++x) {
        mesh.positions.push_back({0.5 * x, 0.5 * y, 0});
        same.numbers.push_back(number);
        growing.numbers.push_back(number + x);
      }
    }
    for (const int v : {0, 1, 3, 4}) {
      mesh.triangles.push_back({v, v + 1, v + 4});
      mesh.triangles.push_back({v, v + 4, v + 3});
    }
    mesh.points = {same, growing};
    write_text(folder / name, vtp_text(mesh));
  }
};

// Colours alone: they do not depend on how stripes are solved for.
const Arguments kColors = {"--color-on", "surface", "--stripe-width", "0", "--legend", "none"};

Arguments joined(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST_F(AnimateStyle, FirstFramesAreThePicturesOfStripe) {
  const char* torus = "shape:torus,resolution=24";
  const std::vector<Arguments> styles = {
      joined({"--color-by", "distance:camera"}, kColors),
      joined({"--color-by", "height", "--with", "shape:sphere,resolution=8@#ff0000"}, kColors),
      {"--stripe-width", "0", "--depth-cue", "haze", "--outline", "solid", "--ground-shadow"},
      {"--stripe-width", "0", "--color-by", "curvature", "--color-on", "surface"},
      {"--stripe-width", "0", "--with", "shape:sphere,resolution=8@color-by=height@outlined@0,0,2"},
      {"--stripe-width", "0", "--color-by", "distance:camera", "--color-on", "surface", "--with",
       "shape:box,resolution=6@color-by=distance:0,0,1"}};
  for (const Arguments& style : styles) {
    expect_run({"animate", torus, "--frames", "1", "-o", "frame%d.png"}, style);
    expect_run({"stripe", torus, "-o", "still.png"}, style);
    EXPECT_EQ(picture("frame0.png").pixels, picture("still.png").pixels) << style[1];
  }
}

TEST_F(AnimateStyle, StylesFollowMovingShapes) {
  expect_run({"animate", "shape:torus,resolution=24", "--scene", "wobble", "--frames", "2", "-o",
              "%d.png", "--color-by", "distance:1,0,0"},
             kColors);
  EXPECT_NE(picture("0.png").pixels, picture("1.png").pixels);
  for (const Arguments& style : std::vector<Arguments>{
           {"--width-by", "light,cross-hatch=0.7"},
           {"--between", "nothing"},
           {"--texture", "dots", "--texture-by", "height,regions=0,plus@#ff0000"}}) {
    expect_run({"animate", "shape:torus,resolution=24", "--scene", "vortices", "--frames", "2",
                "--stripes", "8", "-o", "%d.png"},
               style);
    EXPECT_NE(picture("0.png").pixels, picture("1.png").pixels) << style[0];
  }
}

TEST_F(AnimateStyle, WarnsOnceThatMotifsAreLeftOut) {
  const std::string noise = "shape:sphere,noise=1,resolution=16";
  run({"stripe", noise, "--field", "raw-curvature", "--stripes", "60", "-o", "step0.vtp"});
  std::filesystem::copy(folder / "step0.vtp", folder / "step1.vtp");
  const auto warnings = [&](const char* tile) {
    const ToolResult result =
        run({"animate", "--series", "step%d.vtp", "--field", "array:direction", "--stripes", "60",
             "--texture", tile, "--size", "96x72", "-o", "frame%d.png"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::size_t first = result.err.find("motifs are whole in only");
    if (first == std::string::npos) return 0;
    return result.err.find("motifs are whole in only", first + 1) == std::string::npos ? 1 : 2;
  };
  EXPECT_EQ(warnings("arrows"), 1);
  EXPECT_EQ(warnings("checker"), 0);  // cut, not left out
}

TEST_F(AnimateStyle, ArraysAreThoseOfTheStep) {
  write_step("step0.vtp", 0);
  write_step("step1.vtp", 4);
  write_step("middle.vtp", 2);
  const Arguments colors = joined({"--color-by", "array:growing@0..6", "--up", "z"}, kColors);
  expect_run({"animate", "--series", "step%d.vtp", "--interpolate", "1", "-o", "frame%d.png"},
             colors);
  int frame = 0;
  for (const char* step : {"step0.vtp", "middle.vtp", "step1.vtp"}) {
    expect_run({"stripe", step, "-o", "still.png"}, colors);
    EXPECT_EQ(picture("frame" + std::to_string(frame++) + ".png").pixels,
              picture("still.png").pixels)
        << step;
  }
}

// Surfaces that move may do so beyond a plane, which is no mistake; it is said.
TEST_F(AnimateStyle, FramesOfWhichASliceLeavesNothingAreSaid) {
  for (const Arguments& style : {Arguments{}, Arguments{"--flat"}}) {
    Arguments arguments = {"animate",  "shape:torus,resolution=24",
                           "--frames", "2",
                           "--size",   "96x72",
                           "-o",       "frame%d.png",
                           "--slice",  "z=-9"};
    arguments.insert(arguments.end(), style.begin(), style.end());
    const ToolResult empty = run(arguments);
    EXPECT_EQ(empty.exit_code, 0) << empty.err;
    const std::string said = empty.out + empty.err;
    EXPECT_NE(said.find("warning: frame 0: --slice leaves nothing"), std::string::npos) << said;
    EXPECT_NE(said.find("in 2 of 2 frames"), std::string::npos) << said;
    arguments.back() == "z=-9" ? arguments.back() = "z=50%" : arguments.end()[-2] = "z=50%";
    const ToolResult half = run(arguments);
    EXPECT_EQ((half.out + half.err).find("--slice"), std::string::npos) << half.out << half.err;
  }
}

TEST_F(AnimateStyle, EndsOfValuesAreThoseOfTheFirstFrame) {
  write_step("step0.vtp", 0);
  write_step("step1.vtp", 1);
  expect_run(
      {"animate", "--series", "step%d.vtp", "-o", "own%d.png", "--color-by", "array:growing"},
      kColors);
  expect_run(
      {"animate", "--series", "step%d.vtp", "-o", "set%d.png", "--color-by", "array:growing@0..2"},
      kColors);
  EXPECT_EQ(picture("own1.png").pixels, picture("set1.png").pixels);
  EXPECT_NE(picture("own0.png").pixels, picture("own1.png").pixels);
}

TEST_F(AnimateStyle, TexturesFlowWithTime) {
  for (int step = 0; step < 3; ++step) write_step("step" + std::to_string(step) + ".vtp", 1);
  const Arguments series = {"animate", "--series", "step%d.vtp", "--direction",
                            "1,0,0",   "--along",  "--stripes",  "4"};
  expect_run(series, {"-o", "still%d.png", "--texture", "dots"});
  expect_run(series, {"-o", "flow%d.png", "--texture", "dots,flow=2,0", "--fps", "4"});
  EXPECT_EQ(picture("still0.png").pixels, picture("still1.png").pixels);
  EXPECT_EQ(picture("flow0.png").pixels, picture("still0.png").pixels);
  // Half a tile, then a whole one.
  EXPECT_NE(picture("flow1.png").pixels, picture("flow0.png").pixels);
  EXPECT_EQ(picture("flow2.png").pixels, picture("flow0.png").pixels);
  expect_run(series, {"-o", "shift%d.png", "--texture", "dots,shift=0.5"});
  EXPECT_EQ(picture("flow1.png").pixels, picture("shift0.png").pixels);
}

TEST_F(AnimateStyle, WithoutEffectOrSenseAreRefused) {
  const Arguments torus = {"animate", "shape:torus,resolution=16", "--frames", "1"};
  const auto refused = [&](const std::string& said, const Arguments& more) {
    expect_refusal(2, said, joined(torus, more));
  };
  refused("--color-by", {"--color-by", "height"});
  refused("--texture", {"--texture", "dots"});
  refused("--texture-flow: is written as --texture ...,flow=U[,V]",
          {"--texture-flow", "1", "-o", "%d.png"});
  refused("--texture ...,flow=U[,V]", {"--texture", "dots,flow=1,2,3", "-o", "%d.png"});
  refused("--color-by", {"--color-by", "height", "--view", "branches", "-o", "%d.png"});
  refused("--stripe-width", {"--texture", "dots", "--stripe-width", "0.3", "-o", "%d.png"});
  refused("--stripes-v", {"--stripes-v", "3", "-o", "%d.png"});
  refused("--fps", {"--texture", "dots", "--fps", "3", "-o", "%d.png"});
  refused("--color-by", {"--color-by", "nonsense", "-o", "%d.png"});
  expect_refusal(1, "no array 'speed'",
                 joined(torus, {"--color-by", "array:speed", "-o", "%d.png"}));
  expect_refusal(1, "none.csv", joined(torus, {"--width-by", "none.csv", "-o", "%d.png"}));
}

}  // namespace
}  // namespace brindle::test

#endif
