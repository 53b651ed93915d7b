// Options that would change nothing are wrong usage.
#include <string>

#include "tool.h"

namespace brindle::test {
namespace {

using Arguments = std::vector<std::string>;

std::string joined(const Arguments& arguments) {
  std::string text;
  for (const std::string& argument : arguments) text += ' ' + argument;
  return text;
}

struct Options : ToolTest {
  void SetUp() override {
    ToolTest::SetUp();
    std::string field;
    for (int i = 0; i < 4; ++i) field += "1,0,0\n";
    write_text(folder / "field.csv", field);
    write_text(folder / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  }
};

TEST_F(Options, WithoutEffectAreRefused) {
  // The command, then the option in question, then what leaves it without effect.
  const std::vector<Arguments> refused = {
      {"stripe", "--epsilon", "0.5"},
      {"stripe", "--epsilon", "0.5", "--solver", "multilevel"},
      {"stripe", "--momentum", "0.1", "--solver", "global"},
      {"stripe", "--seed", "3"},
      {"stripe", "--global-iterations", "5"},
      {"stripe", "--global-iterations", "5", "--solver", "relaxation"},
      {"stripe", "--sweeps", "3", "--solver", "relaxation"},
      {"stripe", "--sweeps", "3", "--solver", "averaged", "--cycles", "0"},
      {"curves", "--epsilon", "0.5"},
      {"sample", "--seed", "1"},
      {"stripe", "--curvature-anchor", "0.1", "--direction", "1,0,0"},
      {"stripe", "--curvature-anchor", "0.1", "--field", "raw-curvature"},
      {"stripe", "--curvature-anchor", "0", "--field", "curvature"},
      {"stripe", "--feature-anchor", "1", "--direction", "1,0,0"},
      {"stripe", "--feature-anchor", "1", "--field", "field.csv"},
      {"stripe", "--feature-angle", "30"},
      {"stripe", "--feature-radius", "5%"},
      {"stripe", "--normal-radius", "5%", "--direction", "1,0,0"},
      {"stripe", "--normal-radius", "5%", "--field", "raw-curvature"},
      {"stripe", "--strokes", "strokes.json", "--direction", "1,0,0"},
      {"curves", "--strokes", "strokes.json", "--field", "field.csv"},
      {"animate", "--strokes", "strokes.json"},
      {"stripe", "--feature-angle", "30", "--direction", "1,0,0"},
      {"stripe", "--curvature-direction", "min"},
      {"stripe", "--curvature-direction", "min", "--direction", "1,0,0"},
      {"stripe", "--curvature-direction", "min", "--field", "field.csv"},
      {"compare", "--curvature-direction", "min"},
      {"curves", "--feature-angle", "30"},
      {"sample", "--feature-angle", "30"},
      {"bench", "--curvature-anchor", "0.1"},
      {"stripe", "--tensor", "minor"},
      {"stripe", "--tensor", "minor", "--field", "field.csv"},
      {"curves", "--tensor", "minor", "--frequency-by", "array:a"},
      {"stripe", "--frequency-range", "1,2"},
      {"sample", "--frequency-range", "1,2", "--frequency", "array:a"},
      {"compare", "--frequency-by", "array:a", "--frequency", "array:b"},
      {"stripe", "--field-mesh", "mesh.obj"},
      {"bench", "--field-mesh", "mesh.obj", "--field", "field.csv"},
      {"stripe", "--max-distance", "1%", "--field", "array:a"},
      {"stripe", "--along", "--cross"},
      {"stripe", "--weights", "cotangent", "--points"},
      {"stripe", "--feature-anchor", "1", "--points"},
      {"compare", "--weights", "cotangent", "--points"},
      {"sample", "--feature-anchor", "1", "--points"},
      {"curves", "--stripes-v", "20"},
      {"curves", "--frequency-v", "20", "--lines", "u"},
      {"curves", "--field-v", "field.csv"},
      {"curves", "--wales", "20"},
      {"curves", "--stripes-v", "20", "--wales", "20", "--lines", "v"},
      {"curves", "--winding", "loop-1:1", "--lines", "v"},
      {"curves", "--anchor-boundary", "0", "--lines", "v"},
      {"curves", "--anchor-boundary", "0", "--solver", "relaxation"},
      {"curves", "--winding", "1", "--anchor-boundary", "0"},
      {"stripe", "--cancel-branches", "0", "--points"},
      {"stripe", "--winding", "1", "--points"},
      {"stripe", "--cancel-distance", "20", "--cross"},
      {"stripe", "--cancel-distance", "20"},
      {"stripe", "--rounded"},
      {"stripe", "--rounded", "--subdivide", "0"},
      {"curves", "--tube-radius", "1%"},
      {"curves", "--tube-sides", "5", "--output", "a.obj"},
      {"animate", "--lambda", "0.1", "--solver", "relaxation"},
      {"animate", "--sweeps", "3", "--solver", "relaxation"},
      {"animate", "--iterations", "3"},
      {"animate", "--fps", "25"},
      {"animate", "--direction", "1,0,0", "--scene", "brush"},
      {"bench", "--subdivide", "1", "--figure", "13"},
      {"bench", "--global-limit", "100", "--figure", "14"},
#ifdef BRINDLE_HAS_GL
      {"stripe", "--cycles", "2", "--device", "gpu", "--solver", "relaxation"},
      {"stripe", "--stripes-v", "20"},
      {"stripe", "--camera", "10,10"},
      {"stripe", "--projection", "orthographic"},
      {"stripe", "--min-area", "4", "--output", "a.png"},
      {"stripe", "--min-area", "4"},
      {"stripe", "--up", "z", "--output", "a.ply"},
      {"stripe", "--size", "64x48", "--report", "a.json"},
      {"stripe", "--quality", "interactive"},
      {"stripe", "--quality", "final", "--output", "a.ply"},
      {"stripe", "--colors", "f00,0f0"},
      {"stripe", "--colors", "f00,0f0", "--output", "a.ply"},
      {"stripe", "--slice", "z=50%"},
      {"stripe", "--slice", "z=50%", "--frequency-by", "light"},
      {"curves", "--slice", "z=50%", "--output", "a.obj"},
      {"sample", "--slice", "z=50%", "--output", "a.csv"},
      {"animate", "--slice", "z=50%"},
      {"stripe", "--light-from", "60,20"},
      {"stripe", "--light-from", "60,20", "--output", "a.svg"},
      {"stripe", "--light-from", "60,20", "--output", "a.ply"},
      {"stripe", "--light-from", "60,20", "--flat", "--output", "a.png"},
      {"stripe", "--light-from", "60,20", "--frequency-by", "distance:camera"},
      {"curves", "--light-from", "60,20", "--output", "a.svg"},
      {"sample", "--light-from", "60,20", "--output", "a.csv"},
      {"animate", "--light-from", "60,20"},
      {"animate", "--light-from", "60,20", "--flat", "--frames", "1", "--output", "%d.png"},
      {"stripe", "--view", "branches"},
      {"stripe", "--stripe-width", "0.3"},
      {"stripe", "--stripe-width", "0.3", "--texture", "dots", "--output", "a.png"},
      {"stripe", "--stripe-width", "0.3", "--view", "angle_error", "--output", "a.png"},
      {"stripe", "--colors", "f00,0f0", "--view", "branches", "--output", "a.png"},
      {"stripe", "--quality", "interactive", "--output", "a.svg"},
      {"curves", "--colors", "f00,0f0", "--lines", "v", "--output", "a.svg"},
      {"stripe", "--tiles", "whole", "--output", "a.png"},
      {"stripe", "--tiles", "cut", "--texture", "dots", "--report", "a.json"},
      {"stripe", "--tiles", "whole", "--texture", "dots", "--output", "a.glb"},
      {"stripe", "--tiles", "whole", "--texture", "dots", "--output", "a.obj"},
      {"stripe", "--camera", "10,10", "--texture", "dots", "--output", "a.obj"},
      {"curves", "--camera", "10,10", "--output", "a.obj"},
      {"curves", "--quality", "final", "--output", "a.svg"},
      {"sample", "--quality", "interactive", "--output", "a.csv"},
      {"sample", "--colors", "f00,0f0", "--output", "a.csv"},
      {"animate", "--size", "64x48"},
      {"animate", "--quality", "interactive"},
      {"animate", "--view", "branches"},
      {"animate", "--fps", "25", "--output", "%d.png"},
      {"bench", "--global-limit", "100", "--device", "gpu"},
#endif
  };
  for (const Arguments& row : refused) {
    Arguments arguments = row;
    arguments.insert(arguments.begin() + 1, kTorus16);
    expect_refusal(2, row[1], arguments);
  }
}

TEST_F(Options, WithAnEffectAreTaken) {
  const std::vector<Arguments> taken = {
      {"stripe", "--epsilon", "0.5", "--momentum", "0.1", "--seed", "3", "--solver", "relaxation"},
      {"stripe", "--epsilon", "0.5", "--seed", "3", "--solver", "averaged"},
      {"stripe", "--sweeps", "3"},
      {"stripe", "--sweeps", "3", "--cycles", "1", "--solver", "relaxation"},
      {"compare", "--epsilon", "0.5", "--seed", "3", "--sweeps", "3", "--global-iterations", "5"},
      {"stripe", "--field", "curvature", "--curvature-direction", "min"},
      {"stripe", "--field", "curvature", "--curvature-anchor", "0.3"},
      {"stripe", "--field", "raw-curvature", "--curvature-direction", "min"},
      {"stripe", "--curvature-anchor", "0.1", "--curvature-direction", "min"},
      {"stripe", "--feature-anchor", "1", "--feature-angle", "30"},
      {"stripe", "--field", "curvature", "--feature-anchor", "1"},
      {"stripe", "--feature-anchor", "1", "--feature-radius", "5%"},
      {"stripe", "--normal-radius", "5%"},
      {"stripe", "--along", "--rotate", "10"},
      {"stripe", "--cross", "--rotate", "10"},
      {"curves", "--lines", "both", "--stripes-v", "20"},
      {"curves", "--cancel-branches", "0", "--solver", "relaxation"},
      {"stripe", "--cancel-branches", "0.1"},
      {"stripe", "--cancel-branches", "0.1", "--cross"},
      {"stripe", "--cancel-branches", "0.1", "--texture", "dots"},
      {"curves", "--tube-radius", "1%", "--tube-sides", "5", "--output", "a.ply"},
      {"sample", "--stripes-v", "20"},
      {"animate", "--frames", "2", "--lambda", "0.1", "--sweeps", "3"},
      {"animate", "--frames", "2", "--solver", "relaxation", "--iterations", "3"},
      {"animate", "--frames", "2", "--solver", "relaxation", "--sweeps", "3",
       "--compare-from-scratch"},
      {"animate", "--frames", "2", "--along", "--scene", "brush"},
#ifdef BRINDLE_HAS_GL
      {"stripe", "--camera", "10,10", "--up", "y", "--size", "64x48", "--colors", "f00,0f0,fff",
       "--view", "branches", "--stripe-width", "0.3", "--output", "a.png"},
      {"stripe", "--texture", "dots", "--colors", "f00,0f0", "--output", "a.glb"},
      {"stripe", "--texture", "dots", "--tiles", "cut", "--output", "a.ply"},
      {"stripe", "--cross", "--tiles", "whole", "--output", "a.png"},
      {"stripe", "--quality", "interactive", "--size", "64x48", "--output", "a.png"},
      {"curves", "--quality", "interactive", "--size", "64x48", "--output", "a.png"},
      {"curves", "--camera", "top,2", "--projection", "orthographic", "--size", "64x48", "--output",
       "a.svg"},
      {"stripe", "--light-from", "60,20", "--frequency-by", "light", "--report", "a.json"},
      {"stripe", "--light-from", "60,20", "--color-by", "light", "--flat", "--size", "64x48",
       "--output", "a.png"},
      {"stripe", "--light-from", "60,20", "--width-by", "light", "--size", "64x48", "--output",
       "a.svg"},
      {"stripe", "--slice", "-z=50%", "--size", "64x48", "--output", "a.svg"},
      {"curves", "--slice", "0,0,0,1,1,0", "--size", "64x48", "--output", "a.svg"},
      {"animate", "--slice", "y=0.1", "--size", "64x48", "--frames", "2", "--output", "%d.png"},
      {"sample", "--light-from", "60,20", "--size", "64x48", "--output", "a.png"},
      {"animate", "--light-from", "60,20", "--size", "64x48", "--frames", "2", "--output",
       "%d.png"},
      {"curves", "--tube-radius", "1%", "--size", "64x48", "--output", "a.png"},
#endif
  };
  for (const Arguments& row : taken) {
    Arguments arguments = row;
    arguments.insert(arguments.begin() + 1, kTorus16);
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << joined(arguments) << '\n' << result.err;
  }
  EXPECT_EQ(run({"stripe", "mesh.obj", "--field", "field.csv", "--rotate", "5"}).exit_code, 0);
}

#ifdef BRINDLE_HAS_GL
TEST_F(Options, OfOtherSurfacesThatContradictAreRefused) {
  const auto refused = [&](const std::string& style, const std::string& why) {
    expect_refusal(2, why,
                   {"stripe", kTorus16, "--size", "64x48", "--output", "a.png", "--with",
                    "shape:sphere,radius=0.3" + style});
  };
  const std::string one = "more than one of @opaque, @striped and @discarded";
  for (const std::string style : {"@striped@opaque", "@opaque@striped", "@discarded@striped"}) {
    refused(style, one);
  }
  refused("@#ff0000@#00ff00", "more than one colour");
  refused("@striped@stripes=3@stripes=4", "more than one @stripes");
  refused("@1,0,0@0,1,0", "more than one place");
  refused("@untinted", "nothing is tinted; add --depth-cue");
}
#endif

TEST_F(Options, ThatAreMistypedAreGuessed) {
  expect_refusal(2, "did you mean '--stripes'?", {"stripe", kTorus16, "--stirpes", "20"});
  expect_refusal(2, "did you mean '--stripes'?", {"curves", kTorus16, "--stirpes=20"});
  expect_refusal(2, "did you mean '--version'?", {"--verison"});
  expect_refusal(2, "did you mean 'stripe'?", {"strip", kTorus16});
  expect_refusal(2, "did you mean 'curvature'?", {"stripe", kTorus16, "--field", "curvatur"});
}

}  // namespace
}  // namespace brindle::test
