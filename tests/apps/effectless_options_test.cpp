// Options that would change nothing are wrong usage.
#include <string>
#include <utility>
#include <vector>

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
      {"stripe", "--solver", "multilevel,epsilon=0.5"},
      {"stripe", "--solver", "multilevel,epsilon=0.5"},
      {"stripe", "--solver", "global,momentum=0.1"},
      {"stripe", "--solver", "multilevel,seed=3"},
      {"stripe", "--solver", "multilevel,iterations=5"},
      {"stripe", "--solver", "relaxation,iterations=5"},
      {"stripe", "--solver", "relaxation,sweeps=3"},
      {"stripe", "--solver", "averaged,sweeps=3,cycles=0"},
      {"curves", "--solver", "multilevel,epsilon=0.5"},
      {"sample", "--solver", "multilevel,seed=1"},
      {"stripe", "--curvature-anchor", "0.1", "--direction", "1,0,0"},
      {"stripe", "--curvature-anchor", "0.1", "--field", "raw-curvature"},
      {"stripe", "--curvature-anchor", "0", "--field", "curvature"},
      {"stripe", "--feature-anchor", "1", "--direction", "1,0,0"},
      {"stripe", "--feature-anchor", "1", "--field", "field.csv"},
      {"stripe", "--normal-radius", "5%", "--direction", "1,0,0"},
      {"stripe", "--normal-radius", "5%", "--field", "raw-curvature"},
      {"stripe", "--strokes", "strokes.json", "--direction", "1,0,0"},
      {"curves", "--strokes", "strokes.json", "--field", "field.csv"},
      {"animate", "--strokes", "strokes.json"},
      {"stripe", "--field", "smooth,min"},
      {"stripe", "--field", "smooth,min", "--direction", "1,0,0"},
      {"stripe", "--field", "field.csv,min"},
      {"compare", "--field", "smooth,min"},
      {"stripe", "--feature-anchor", "0,angle=30"},
      {"curves", "--feature-anchor", "0,radius=5%"},
      {"sample", "--feature-anchor", "0,angle=30"},
      {"compare", "--curvature-anchor", "0.1", "--direction", "1,0,0"},
      {"stripe", "--tensor", "minor"},
      {"stripe", "--tensor", "minor", "--field", "field.csv"},
      {"curves", "--tensor", "minor", "--frequency-by", "array:a"},
      {"compare", "--frequency-by", "array:a", "--frequency", "array:b"},
      {"stripe", "--field-mesh", "mesh.obj"},
      {"compare", "--field-mesh", "mesh.obj", "--field", "field.csv"},
      {"stripe", "--along", "--cross"},
      {"stripe", "--solver", "multilevel,weights=cotangent", "--points"},
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
      {"stripe", "--subdivide", "0,rounded"},
      {"curves", "--tube-radius", "1%"},
      {"curves", "--tube-sides", "5", "--output", "a.obj"},
      {"animate", "--solver", "relaxation,lambda=0.1"},
      {"animate", "--solver", "relaxation,sweeps=3"},
      {"animate", "--solver", "multilevel,iterations=3"},
      {"animate", "--fps", "25"},
      {"animate", "--direction", "1,0,0", "--scene", "brush"},
#ifdef BRINDLE_HAS_GL
      {"stripe", "--solver", "relaxation,cycles=2", "--device", "gpu"},
      {"stripe", "--stripes-v", "20"},
      {"stripe", "--camera", "10,10"},
      {"stripe", "--camera", "30,20,orthographic"},
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
      {"stripe", "--texture", "dots,cut", "--report", "a.json"},
      {"stripe", "--texture", "dots,whole", "--output", "a.glb"},
      {"stripe", "--texture", "dots,whole", "--output", "a.obj"},
      {"stripe", "--camera", "10,10", "--texture", "dots", "--output", "a.obj"},
      {"curves", "--camera", "10,10", "--output", "a.obj"},
      {"curves", "--quality", "final", "--output", "a.svg"},
      {"sample", "--quality", "interactive", "--output", "a.csv"},
      {"sample", "--colors", "f00,0f0", "--output", "a.csv"},
      {"animate", "--size", "64x48"},
      {"animate", "--quality", "interactive"},
      {"animate", "--view", "branches"},
      {"animate", "--fps", "25", "--output", "%d.png"},
#endif
  };
  for (const Arguments& row : refused) {
    Arguments arguments = row;
    arguments.insert(arguments.begin() + 1, kTorus16);
    expect_refusal(2, row[1], arguments);
  }
}

/// Parts of a value are no options of their own where the whole one is.
TEST_F(Options, ThatArePartsAreRefusedWithTheirSpelling) {
  const std::vector<std::pair<Arguments, std::string>> refused = {
      {{"stripe", "--epsilon", "0.5"}, "--solver ...,epsilon=E"},
      {{"curves", "--global-iterations=5"}, "--solver ...,iterations=N"},
      {{"stripe", "--color-range", "0,1"}, "--color-by ...@A..B"},
      {{"sample", "--size-range", "0..1"}, "--size-by ...@A..B"},
      {{"stripe", "--rounded"}, "--subdivide ...,rounded"},
      {{"stripe", "--tensor-order", "voigt"}, "--tensor ...,vtk|voigt|plane"},
      {{"stripe", "--no-legend"}, "--legend none"},
      {{"animate", "--lambda", "0.1"}, "--solver ...,lambda=L"},
      {{"stripe", "--lambda", "0.1"}, "--previous ...,lambda=L"},
#ifdef BRINDLE_HAS_GL
      {{"stripe", "--pixel-width", "3"}, "--stripe-width Npx"},
      {{"stripe", "--line-width", "3"}, "--outline ...,width=PIXELS"},
#endif
  };
  for (const auto& [row, spelling] : refused) {
    Arguments arguments = row;
    arguments.insert(arguments.begin() + 1, kTorus16);
    const std::string option = row[1].substr(0, row[1].find('='));
    expect_refusal(2, option + ": is written as " + spelling, arguments);
  }
}

TEST_F(Options, HaveThePartsThatTheyHave) {
  const auto refused = [&](const std::string& why, const Arguments& more) {
    Arguments arguments = {"stripe", kTorus16};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refusal(2, why, arguments);
  };
  refused("--solver: has no part 'epsilom=' (did you mean 'epsilon='?)",
          {"--solver", "relaxation,epsilom=1"});
  refused("--solver: has no part 'foo='", {"--solver", "relaxation,epsilon=1,foo=1"});
  refused("--solver ...,epsilon=E: lacks its value", {"--solver", "relaxation,epsilon="});
  refused("--solver ...,epsilon=E: ", {"--solver", "relaxation,epsilon=1,epsilon=2"});
  refused("--subdivide: has no part 'round' (did you mean 'rounded'?); it has rounded",
          {"--subdivide", "1,rounded,round"});
  refused("--solver: expected one of multilevel", {"--solver=,epsilon=1"});
  refused("--solver ...,epsilon=E: has no effect here: it is for --solver relaxation",
          {"--solver=global,epsilon=1"});
}

/// With another order of parts, behind an equals sign, or with what looks like parts in names.
TEST_F(Options, WithPartsAreTheSameInAnyOrder) {
  const auto report = [&](const Arguments& more) {
    Arguments arguments = {"stripe", kTorus16, "--report", "a.json", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return content(folder / "a.json");
  };
  const auto options = [&](const Arguments& more) {
    const std::string text = report(more);
    const std::size_t begin = text.find("\"options\"");
    return text.substr(begin, text.find('}', begin) - begin);
  };
  const std::string expected = options({"--solver", "relaxation,seed=3,epsilon=0.5"});
  EXPECT_EQ(options({"--solver=relaxation,epsilon=0.5,seed=3"}), expected);
  EXPECT_TRUE(has(expected, "\"epsilon\": \"0.5\""));
  EXPECT_TRUE(has(expected, "\"seed\": \"3\""));
  const std::string text = report({});
  const int vertices = std::stoi(text.substr(text.find("\"vertices\": ") + 12));
  std::string values = "value\n";
  for (int v = 0; v < vertices; ++v) values += std::to_string(v) + '\n';
  write_text(folder / "at@home.csv", values);
  EXPECT_TRUE(has(report({"--frequency-by", "at@home.csv"}), "at@home.csv"));
  EXPECT_TRUE(has(report({"--frequency-by", "./at@home.csv@0.5..2,inverse"}), "0.5..2,inverse"));
  EXPECT_TRUE(has(report({"--frequency-by", "distance:0,0,0@0.5..2"}), "\"distance:0,0,0\""));
}

TEST_F(Options, WithAnEffectAreTaken) {
  const std::vector<Arguments> taken = {
      {"stripe", "--solver", "relaxation,epsilon=0.5,momentum=0.1,seed=3"},
      {"stripe", "--solver", "averaged,epsilon=0.5,seed=3"},
      {"stripe", "--solver", "multilevel,sweeps=3"},
      {"stripe", "--solver", "relaxation,sweeps=3,cycles=1"},
      {"compare", "--epsilon", "0.5", "--seed", "3", "--sweeps", "3", "--global-iterations", "5"},
      {"stripe", "--field", "curvature,min"},
      {"stripe", "--field", "curvature", "--curvature-anchor", "0.3"},
      {"stripe", "--field", "raw-curvature,min"},
      {"stripe", "--curvature-anchor", "0.1", "--field", "smooth,min"},
      {"stripe", "--feature-anchor", "1,angle=30"},
      {"stripe", "--field", "curvature", "--feature-anchor", "1"},
      {"stripe", "--feature-anchor", "1,radius=5%"},
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
      {"animate", "--frames", "2", "--solver", "multilevel,lambda=0.1,sweeps=3"},
      {"animate", "--frames", "2", "--solver", "relaxation,iterations=3"},
      {"animate", "--frames", "2", "--solver", "relaxation,sweeps=3", "--compare-from-scratch"},
      {"animate", "--frames", "2", "--along", "--scene", "brush"},
#ifdef BRINDLE_HAS_GL
      {"stripe", "--camera", "10,10", "--up", "y", "--size", "64x48", "--colors", "f00,0f0,fff",
       "--view", "branches", "--stripe-width", "0.3", "--output", "a.png"},
      {"stripe", "--texture", "dots", "--colors", "f00,0f0", "--output", "a.glb"},
      {"stripe", "--texture", "dots,cut", "--output", "a.ply"},
      {"stripe", "--cross", "--texture", "checker,whole", "--output", "a.png"},
      {"stripe", "--quality", "interactive", "--size", "64x48", "--output", "a.png"},
      {"curves", "--quality", "interactive", "--size", "64x48", "--output", "a.png"},
      {"curves", "--camera", "top,2,orthographic", "--size", "64x48", "--output", "a.svg"},
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
  refused("@color-by=height@0..1@0..2", "more than one range");
  refused("@color-by=height@1..0", "the smaller one first");
  refused("@0..1", "MESH[@opaque");
  const std::string sphere = "shape:sphere,radius=0.3@color-by=height@0..1";
  expect_refusal(2, "have two ranges",
                 {"stripe", kTorus16, "--size", "64x48", "--output", "a.png", "--color-by",
                  "height@0..3", "--with", sphere});
}
#endif

TEST_F(Options, ThatAreMistypedAreGuessed) {
  expect_refusal(2, "did you mean '--stripes'?", {"stripe", kTorus16, "--stirpes", "20"});
  expect_refusal(2, "did you mean '--stripes'?", {"curves", kTorus16, "--stirpes=20"});
  expect_refusal(2, "did you mean '--version'?", {"--verison"});
  expect_refusal(2, "did you mean 'stripe'?", {"strip", kTorus16});
  expect_refusal(2, "did you mean 'stripe shape:torus'?", {"shape:torus", "--stripes", "20"});
  expect_refusal(2, "'wind.vtp' is a mesh; for an array of it, add --field array:NAME --field-mesh",
                 {"stripe", kTorus16, "--field", "wind.vtp"});
  expect_refusal(2, "did you mean 'curvature'?", {"stripe", kTorus16, "--field", "curvatur"});
}

}  // namespace
}  // namespace brindle::test
