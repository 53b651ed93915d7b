#include <cstdlib>
#include <filesystem>
#include <string>

#include "tool.h"

#ifdef BRINDLE_HAS_GL

#include "brindle/image.h"

namespace brindle::test {
namespace {

using Arguments = std::vector<std::string>;

const char* const kSquare = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n";

struct StyleTool : ToolTest {
  static Arguments with(const Arguments& more,
                        const std::string& mesh = "shape:torus,resolution=24") {
    Arguments arguments = {"stripe", mesh, "--stripes", "8", "-o", "out.png", "--size", "96x72"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  Image picture(const Arguments& more, const std::string& mesh = "shape:torus,resolution=24") {
    const ToolResult result = run(with(more, mesh));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_png(folder / "out.png");
  }
};

TEST_F(StyleTool, EveryStyleChangesThePicture) {
  const Image plain = picture({});
  const std::vector<Arguments> styles = {
      {"--width-by", "height"},
      {"--width-by", "curvature@1px..4px"},
      {"--width-by", "light,cross-hatch=0.6,tones=0.2..0.9"},
      {"--color-by", "distance:1,0,0", "--colormap", "magma", "--threshold", "1"},
      {"--color-by", "distance:camera", "--color-on", "surface", "--legend", "none"},
      {"--opacity-by", "height@1..0.2"},
      {"--color-by", "light", "--color-on", "surface", "--flat"},
      {"--frequency-by", "distance:camera"},
      {"--frequency-by", "light@1..2,inverse"},
      {"--stripe-width", "3px", "--stroke-spacing", "4"},
      {"--between", "nothing"},
      {"--with", "shape:sphere,resolution=6@#ff0000"},
      {"--light-from", "70,10"},
      {"--slice", "z=50%"},
      {"--flat"},
      {"--transparent"},
      {"--depth-cue", "chroma"},
      {"--depth-cue", "haze"},
      {"--outline", "dashed,width=2"},
      {"--creases", "10", "--outline", "solid,hidden=dashed"}};
  for (const Arguments& style : styles) {
    EXPECT_NE(picture(style).pixels, plain.pixels) << style[0] << ' ' << style.back();
  }
}

// As those within volumes, and copies that reading has joined with others.
TEST_F(StyleTool, VerticesThatNoTriangleUsesAreNotSeen) {
  ASSERT_EQ(run({"stripe", "shape:torus,resolution=12", "-o", "torus.obj", "-q"}).exit_code, 0);
  write_text(folder / "more.obj", content(folder / "torus.obj") + "v 0 0 100\nv 50 0 -3\n");
  const std::vector<Arguments> styles = {{"--color-by", "height", "--ground-shadow"},
                                         {"--width-by", "distance:1,0,0", "--field", "curvature"},
                                         {"--opacity-by", "height"},
                                         {"--texture", "dots", "--tile-size-by", "height"},
                                         {"--depth-cue", "haze", "--frequency-by", "height"},
                                         {"--with", "torus.obj@color-by=height"}};
  for (const Arguments& style : styles) {
    Arguments with_more = style;
    for (std::string& word : with_more) {
      if (word.starts_with("torus.obj")) word.replace(0, 9, "more.obj");
    }
    EXPECT_EQ(picture(with_more, "more.obj").pixels, picture(style, "torus.obj").pixels)
        << style[0];
  }
}

// Whatever reads the light reads the one that is asked for.
TEST_F(StyleTool, LightMovesAllThatFollowsIt) {
  for (const Arguments& follows :
       {Arguments{"--width-by", "light"}, Arguments{"--color-by", "light", "--flat"},
        Arguments{"--frequency-by", "light"}, Arguments{"--opacity-by", "light", "--flat"},
        Arguments{"--texture", "dots", "--tile-size-by", "light", "--flat"},
        Arguments{"--view", "branches"}, Arguments{"--points"}}) {
    const Image usual = picture(follows);
    Arguments moved = follows;
    moved.insert(moved.end(), {"--light-from", "80,-20"});
    EXPECT_NE(picture(moved).pixels, usual.pixels) << follows[0];
  }
}

TEST_F(StyleTool, OtherSurfacesStayWholeWhereTheyAreToldTo) {
  const std::string ball = "shape:sphere,radius=0.5,resolution=8@#ff0000";
  const auto red = [&](const Arguments& more) {
    Arguments arguments = {"--flat", "--colors", "000,fff,fff", "--with", ball};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::size_t count = 0;
    for (const Pixel& pixel : picture(arguments).pixels) {
      count += pixel.red > 200 && pixel.green < 50 ? 1 : 0;
    }
    return count;
  };
  const std::size_t cut = red({"--slice", "z=0"});
  const std::size_t whole =
      red({"--slice", "z=0", "--with", "shape:sphere,radius=0.5,resolution=8@whole@#ff0000"});
  EXPECT_GT(whole, cut + 100);
  for (const Arguments& refused :
       {Arguments{"--with", ball + "@whole"},
        Arguments{"--with", ball + "@whole", "--slice", "z=0", "--outline", "solid"}}) {
    EXPECT_EQ(run(with(refused)).exit_code, 2);
  }
}

/// A square that stands upright, with a number at every vertex.
const char* const kMeasured =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty float speed\nelement face 2\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0 1\n1 0 0 2\n0 0 1 4\n1 0 1 8\n3 0 1 2\n3 1 3 2\n";

/// Of other surfaces, beside a first one of which nothing is seen.
struct OtherSurfaceTool : StyleTool {
  void SetUp() override {
    StyleTool::SetUp();
    write_text(folder / "square.ply", kMeasured);
  }

  static Arguments flat(const Arguments& more) {
    Arguments all = {"--flat", "--colors", "1c325a,f4efe6,ffffff", "--camera", "0,0"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Image first(const std::string& mesh, const Arguments& more) { return picture(flat(more), mesh); }
  Image other(const std::string& mesh, const std::string& parts, const Arguments& more = {}) {
    Arguments all = {"--between", "nothing", "--stripe-width", "0", "--with", mesh + parts};
    all.insert(all.end(), more.begin(), more.end());
    return first(mesh, all);
  }
  void expect_refused(const std::string& words, const Arguments& arguments) const {
    const ToolResult result = run(with(arguments));
    EXPECT_EQ(result.exit_code, 2) << words;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  }
};

TEST_F(OtherSurfaceTool, LooksAsTheFirstDoes) {
  const std::string square = (folder / "square.ply").string(), torus = "shape:torus,resolution=24";
  write_text(folder / "speeds.csv", "speed\n1\n2\n4\n8\n");
  EXPECT_EQ(
      other(square, "@color-by=array:speed").pixels,
      first(square, {"--stripe-width", "0", "--color-by", "array:speed", "--color-on", "surface"})
          .pixels);
  EXPECT_EQ(other(square, "@color-by=" + (folder / "speeds.csv").string()).pixels,
            other(square, "@color-by=array:speed").pixels);
  EXPECT_EQ(other(torus, "@striped@stripe-width=0.5@#f4efe6@color-by=distance:1,0,0").pixels,
            first(torus, {"--color-by", "distance:1,0,0"}).pixels);
  EXPECT_EQ(other(torus, "@discarded@stripe-width=0.5@color-by=height").pixels,
            first(torus, {"--color-by", "height", "--between", "nothing"}).pixels);
  for (const std::string tile : {"dots", "checker"}) {
    EXPECT_EQ(other(torus, "@texture=" + tile + "@stripes=8@#f4efe6").pixels,
              first(torus, {"--texture", tile}).pixels)
        << tile;
  }
  EXPECT_EQ(other(torus, "@texture=dots@stripes=8@color-by=curvature").pixels,
            first(torus, {"--texture", "dots", "--color-by", "curvature"}).pixels);
  EXPECT_EQ(other(torus, "@discarded@texture=plus@stripes=8@color-by=height").pixels,
            first(torus, {"--texture", "plus", "--color-by", "height", "--color-on", "motifs",
                          "--between", "nothing"})
                .pixels);
  EXPECT_EQ(other(torus, "@#f4efe6@outlined").pixels,
            first(torus, {"--stripe-width", "0", "--outline", "solid"}).pixels);
}

// All that shares a value shares its colours, and options of colours are for whoever has them.
TEST_F(OtherSurfaceTool, SharesTheColorsOfAValue) {
  const std::string square = (folder / "square.ply").string();
  const Arguments above = {"--with", square + "@color-by=height@0,0,2"};
  const auto with_range = [&](Arguments arguments, const std::string& range) {
    arguments[1] += "@" + range;
    return arguments;
  };
  // From 0 to 1 and from 2 to 3.
  const Arguments both = {"--color-by", "height", above[0], above[1]};
  EXPECT_EQ(first(square, both).pixels, first(square, with_range(both, "0..3")).pixels);
  EXPECT_NE(first(square, both).pixels, first(square, with_range(both, "0..1")).pixels);
  EXPECT_EQ(first(square, above).pixels, first(square, with_range(above, "2..3")).pixels);
  const std::string by_speed = "@color-by=array:speed";
  EXPECT_EQ(other(square, by_speed + "@1..8").pixels, other(square, by_speed).pixels);
  for (const Arguments& more :
       {Arguments{"--threshold", "3"}, Arguments{"--colormap", "magma"},
        Arguments{"--legend", "speed in m/s"}, Arguments{"--legend", "none"},
        Arguments{"--with", square + "@color-by=height@0,0,2"}}) {
    EXPECT_NE(other(square, by_speed, more).pixels, other(square, by_speed).pixels) << more[0];
  }
}

TEST_F(OtherSurfaceTool, RefusesWhatHasNoEffect) {
  const std::string box = "shape:box,resolution=6";
  expect_refused("--color-on: ", {"--with", box + "@color-by=height", "--color-on", "surface"});
  expect_refused("height and curvature", {"--color-by", "height", "--threshold", "0.1", "--with",
                                          box + "@color-by=curvature"});
  expect_refused("@outlined has no effect", {"--with", box + "@outlined", "--outline", "solid"});
  expect_refused("@whole goes without lines",
                 {"--with", box + "@outlined", "--slice", "z=0", "--with", box + "@whole"});
  expect_refused("is a value of the first surface alone", {"--with", box + "@color-by=light"});
  expect_refused("|curvature|height, got 'speed'", {"--with", box + "@color-by=speed"});
  expect_refused("--with @texture", {"--with", box + "@texture=leaves"});
  const ToolResult missing = run(with({"--with", box + "@color-by=array:speed"}));
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_NE(missing.err.find("speed"), std::string::npos) << missing.err;
  const auto drawing = [&](const std::string& parts) {
    return run({"stripe", box, "--stripes", "8", "-o", "lines.svg", "--with", box + parts});
  };
  EXPECT_EQ(drawing("@texture=dots@outlined@0,0,1").exit_code, 0);
  const ToolResult colored = drawing("@color-by=height");
  EXPECT_EQ(colored.exit_code, 2);
  EXPECT_NE(colored.err.find("write .png"), std::string::npos) << colored.err;
}

TEST_F(StyleTool, SlicesLeaveSomething) {
  for (const Arguments& slice :
       {Arguments{"--slice", "z=-3"}, Arguments{"--slice", "-x=3", "--flat"},
        Arguments{"--slice", "-y=110%", "--points"}}) {
    const ToolResult result = run(with(slice));
    EXPECT_EQ(result.exit_code, 1) << slice[1];
    EXPECT_NE(result.err.find("--slice leaves nothing"), std::string::npos) << result.err;
  }
  const Image beside =
      picture({"--slice", "z=-3", "--with", "shape:sphere,radius=2,resolution=8@0,0,-5"});
  EXPECT_NE(beside.pixels, picture({}).pixels);
}

// What touches the plane alone has no area; what lies within it is not taken away.
TEST_F(StyleTool, SlicesAtTheEndsLeaveNothing) {
  const std::string ball = "shape:sphere,resolution=8";
  const std::vector<Arguments> empty = {
      {"--slice", "z=0%"},
      {"--slice", "-z=100%"},
      {"--slice", "-x=100%", "--flat"},
      {"--slice", "z=-9", "--with", ball + "@0,0,3"},
      {"--slice", "z=-9", "--with", ball + "@0,0,3", "--output", "lines.svg"}};
  for (const Arguments& slice : empty) {
    const ToolResult result = run(with(slice));
    EXPECT_EQ(result.exit_code, 1) << slice[1];
    EXPECT_NE(result.err.find("leaves nothing"), std::string::npos) << result.err;
  }
  picture({"--slice", "z=-9", "--with", ball + "@0,0,3@whole"});
  write_text(folder / "square.obj", kSquare);
  const std::string square = (folder / "square.obj").string();
  EXPECT_EQ(picture({"--slice", "z=0"}, square).pixels, picture({}, square).pixels);
  for (const Arguments& more : {Arguments{}, Arguments{"--glyph", "disc"}}) {
    Arguments arguments = {"sample",    "shape:torus,resolution=24",
                           "--stripes", "8",
                           "-o",        "samples.png",
                           "--size",    "96x72",
                           "--slice",   "z=0%"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("leaves nothing"), std::string::npos) << result.err;
  }
}

// Within a ball of which the nearer half is away, its light is that of the side that is seen, which
// is lit from where the outer one is dark.
TEST_F(StyleTool, ValuesThatFollowTheLightKnowTheSlice) {
  const std::string ball = "shape:sphere,resolution=24";
  const Arguments light = {
      "--up",    "z",      "--camera", "0,0",  "--color-by",     "light@0..1", "--color-on",
      "surface", "--flat", "--legend", "none", "--stripe-width", "0"};
  const auto seen = [&](const std::string& from, bool cut) {
    Arguments arguments = light;
    arguments.insert(arguments.end(), {"--light-from", from});
    if (cut) arguments.insert(arguments.end(), {"--slice", "-y=50%"});
    return picture(arguments, ball);
  };
  const auto brightness = [](const Image& image, int x) {
    const Pixel pixel = image.at(x, image.height / 2);
    return pixel.red + pixel.green + pixel.blue;
  };
  const Image whole = seen("80,0", false), within = seen("80,0", true);
  const int left = 96 / 2 - 22, right = 96 / 2 + 22;
  EXPECT_GT(brightness(whole, right), brightness(whole, left) + 100);
  EXPECT_GT(brightness(within, left), brightness(within, right) + 100);
}

TEST_F(StyleTool, TransparentPicturesHaveNoBackground) {
  EXPECT_EQ(picture({"--transparent"}).at(0, 0).alpha, 0);
  EXPECT_EQ(picture({"--flat"}).at(0, 0).alpha, 255);
}

/// How often it becomes dark or light along the middle row of the right half.
int changes_at_right(const Image& image) {
  const auto is_dark = [&](int x) { return image.at(x, image.height / 2).red < 100; };
  int changes = 0;
  for (int x = image.width / 2 + 1; x < image.width; ++x) {
    changes += is_dark(x) != is_dark(x - 1) ? 1 : 0;
  }
  return changes;
}

TEST_F(StyleTool, OtherSurfacesHaveStripesOfTheirOwn) {
  const Arguments flat = {"--flat",   "--colors", "000,fff",     "--up", "z",
                          "--camera", "0,0",      "--direction", "1,0,0"};
  const auto with_other = [&](const std::string& style) {
    Arguments arguments = flat;
    arguments.insert(arguments.end(),
                     {"--with", "shape:sphere,resolution=16@striped@3,0,0" + style});
    return picture(arguments, "shape:sphere,resolution=16");
  };
  const Image as_first = with_other("");
  const Image full = with_other("@stripe-width=1@stripe-color=#ff0000@#00ff00");
  const Image none = with_other("@stripe-width=0@stripe-color=#ff0000@#00ff00");
  EXPECT_EQ(full.at(72, 36), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(none.at(72, 36), (Pixel{0, 255, 0, 255}));
  const int few = changes_at_right(with_other("@stripes=4"));
  const int many = changes_at_right(with_other("@stripes=16"));
  EXPECT_GT(many, 2 * few);
  EXPECT_LT(changes_at_right(with_other("@rotate=90")), changes_at_right(as_first));
  for (int x = 0; x < 48; ++x) {
    EXPECT_EQ(full.at(x, 36), as_first.at(x, 36)) << "the first surface keeps its style";
  }
  for (const char* refused :
       {"shape:sphere@stripes=4", "shape:sphere@opaque@stripe-color=red",
        "shape:sphere@striped@stripes=0", "shape:sphere@striped@wide=2",
        "shape:sphere@striped@stripe-width=1.5",
        "shape:sphere@striped@rotate=", "shape:sphere@striped@stripe-color=no"}) {
    const ToolResult result = run(with({"--with", refused}));
    EXPECT_EQ(result.exit_code, 2) << refused;
    EXPECT_NE(result.err.find("--with"), std::string::npos) << result.err;
  }
}

// Strokes lie on the first surface, which others are far from.
TEST_F(StyleTool, StrokesAreOfTheFirstSurfaceAlone) {
  write_text(folder / "strokes.json",
             R"({"strokes": [{"radius": 0.2, "points": [[1, 0, 0.3], [1, 0.3, 0.3]]}]})");
  const Arguments other = {"--with", "shape:sphere,resolution=8@striped@0,0,5"};
  Arguments drawn = other;
  drawn.insert(drawn.end(), {"--strokes", (folder / "strokes.json").string()});
  EXPECT_NE(picture(drawn).pixels, picture(other).pixels);
}

TEST_F(StyleTool, OtherSurfacesAreOpaqueStripedOrDiscarded) {
  const Arguments flat = {"--flat", "--colors", "000,fff"};
  const auto with_other = [&](const std::string& other) {
    Arguments arguments = flat;
    arguments.insert(arguments.end(), {"--with", other});
    return picture(arguments);
  };
  const Image opaque = with_other("shape:sphere,radius=2,resolution=8@#ff0000");
  EXPECT_EQ(opaque.at(48, 36), (Pixel{255, 0, 0, 255}));
  const Image striped = with_other("shape:sphere,radius=2,resolution=8@striped@#ff0000");
  EXPECT_NE(striped.pixels, opaque.pixels);
  const Image discarded = with_other("shape:sphere,radius=2,resolution=8@discarded@#ff0000");
  EXPECT_NE(discarded.pixels, striped.pixels);
}

TEST_F(StyleTool, RegionsHaveALegendWhereItHasATitle) {
  const Arguments tiles = {"--texture",    "minus",
                           "--texture-by", "height,regions=0,plus@#ff0000",
                           "--colors",     "0000ff,ffffff,ffffff",
                           "--flat"};
  Arguments titled = with(tiles);
  titled[7] = "320x240";
  titled.insert(titled.end(), {"--legend", "sign"});
  const ToolResult result = run(titled);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Image drawn = read_png(folder / "out.png");
  // Below each other at the right: the tile of large values, red, then that of small ones, blue.
  int red = 0, blue = 0, last_red = 0, first_blue = drawn.height;
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 2 * drawn.width / 3; x < drawn.width; ++x) {
      const Pixel p = drawn.at(x, y);
      if (p.red > 200 && p.blue < 80 && p.green < 80) ++red, last_red = y;
      if (p.blue > 200 && p.red < 80 && p.green < 80) ++blue, first_blue = std::min(first_blue, y);
    }
  }
  EXPECT_GT(red, 5);
  EXPECT_GT(blue, 5);
  EXPECT_LT(last_red, first_blue);
  Arguments refused = with(tiles);
  refused.insert(refused.end(), {"--legend", "none"});
  expect_refusal(2, "--legend none", refused);
}

TEST_F(StyleTool, UntintedSurfacesKeepTheirColours) {
  for (const char* cue : {"chroma", "haze"}) {
    const auto drawn = [&](const std::string& other) {
      return picture({"--flat", "--colors", "000,fff", "--depth-cue", cue, "--with", other});
    };
    const Image own = drawn("shape:sphere,radius=2,resolution=8@untinted@#e6c9a0");
    EXPECT_EQ(own.at(48, 36), (Pixel{0xe6, 0xc9, 0xa0, 255}));
    EXPECT_NE(drawn("shape:sphere,radius=2,resolution=8@#e6c9a0").pixels, own.pixels);
  }
}

TEST_F(StyleTool, ValuesComeFromFilesToo) {
  write_text(folder / "mesh.obj", kSquare);
  write_text(folder / "values.csv", "a,b\n1,4\n2,3\n3,nan\n4,1\n");
  write_text(folder / "one.csv", "a\n1\n2\n3\n4\n");
  const Image a = picture({"--color-by", "values.csv:a", "--color-on", "surface"}, "mesh.obj");
  const Image same = picture({"--color-by", "one.csv", "--color-on", "surface"}, "mesh.obj");
  EXPECT_EQ(a.pixels, same.pixels);
  const Image b = picture({"--color-by", "values.csv:b", "--color-on", "surface"}, "mesh.obj");
  EXPECT_NE(a.pixels, b.pixels);
  ASSERT_EQ(run({"stripe", "mesh.obj", "-o", "made.vtp", "-q"}).exit_code, 0);
  picture({"--width-by", "array:phase", "--color-by", "array:frequency"}, "made.vtp");
}

TEST_F(StyleTool, CoherenceIsThatOfTheFileThatIsWritten) {
  const Arguments measured = {"--field", "raw-curvature", "--field-smoothing", "0.5"};
  Arguments own = measured;
  own.insert(own.end(), {"--color-by", "coherence@0..1", "--color-on", "surface", "--legend",
                         "none", "--up", "z"});
  const Image drawn = picture(own);
  Arguments written = {"stripe", "shape:torus,resolution=24", "--stripes", "8", "-o", "made.vtp"};
  written.insert(written.end(), measured.begin(), measured.end());
  ASSERT_EQ(run(written).exit_code, 0);
  Arguments of_file = measured;
  of_file.insert(of_file.end(), {"--color-by", "array:coherence@0..1", "--color-on", "surface",
                                 "--legend", "none", "--up", "z"});
  Arguments as_measured = measured;
  as_measured.insert(as_measured.end(), {"--up", "z"});
  const Image from_file = picture(of_file, "made.vtp"), plain = picture(as_measured);
  // The file's surface is the same but for rounding.
  const auto far_from_drawn = [&](const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
      const Pixel a = drawn.pixels[i], b = image.pixels[i];
      count += std::abs(a.red - b.red) + std::abs(a.green - b.green) > 16 ? 1 : 0;
    }
    return count;
  };
  EXPECT_LT(far_from_drawn(from_file), 30);
  EXPECT_GT(far_from_drawn(plain), 600);
  expect_refusal(2, "--field-smoothing", with({"--width-by", "coherence"}));
}

TEST_F(StyleTool, BadValuesAreRefused) {
  write_text(folder / "mesh.obj", kSquare);
  write_text(folder / "values.csv", "a,b\n1,nan\n2,nan\n3,nan\n4,nan\n");
  write_text(folder / "short.csv", "a\n1\n2\n");
  const auto refused = [&](int code, const std::string& said, const Arguments& more) {
    expect_refusal(code, said, with(more, "mesh.obj"));
  };
  refused(2, "--color-by", {"--color-by", "nonsense"});
  refused(2, "--color-by", {"--color-by", "distance:1,2"});
  refused(2, "--color-by", {"--color-by", "camera"});
  refused(2, "--frequency-by", {"--frequency-by", "nonsense"});
  refused(2, "array:NAME", {"--width-by", "array:"});
  refused(1, "no array 'speed'", {"--color-by", "array:speed"});
  refused(1, "none.csv", {"--color-by", "none.csv"});
  refused(1, "several columns", {"--color-by", "values.csv"});
  refused(1, "'c'", {"--color-by", "values.csv:c"});
  refused(1, "no values", {"--color-by", "values.csv:b"});
  refused(1, "2 rows", {"--width-by", "short.csv"});
  refused(2, "--colormap", {"--color-by", "height", "--colormap", "jet"});
  refused(2, "--color-by ...@A..B", {"--color-by", "height@2..1"});
  refused(2, "--color-by ...@A..B", {"--color-by", "height@nan..1"});
  refused(2, "--width-by ...@A..B", {"--width-by", "height@0.5..2"});
  refused(2, "--width-by ...@A..B", {"--width-by", "height@1px..2"});
  refused(2, "--opacity-by ...@A..B", {"--opacity-by", "height@0..2"});
  refused(2, "--threshold", {"--color-by", "height", "--threshold", "much"});
  refused(2, "--width-by ...,tones=DARK..LIGHT", {"--width-by", "light,tones=0.8..0.2"});
  refused(2, "--width-by ...,cross-hatch=TONE", {"--width-by", "light,cross-hatch=0"});
  refused(2, "--with", {"--with", "shape:sphere@bluish"});
  refused(2, "--with", {"--with", "shape:sphere@1,2"});
  refused(2, "--frequency-by ...@A..B", {"--frequency-by", "height@1..2,upwards"});
  refused(2, "--stripe-width Npx", {"--stripe-width", "0px"});
  refused(2, "--creases", {"--creases", "180"});
  refused(2, "--occlusion", {"--occlusion", "2"});
  for (const std::string regions :
       {"plus", "0,cross", "1,plus,0,dots", "x,plus", "0,plus@reddish"}) {
    refused(2, "--texture-by ...,regions=",
            {"--texture", "dots", "--texture-by", "height,regions=" + regions});
  }
  refused(2, "--texture ...,shift=U[,V]", {"--texture", "dots,shift=1,2,3"});
  refused(2, "--tile-size-by ...@A..B", {"--texture", "dots", "--tile-size-by", "height@0.1..2"});
  refused(2, "--tile-size-by", {"--tile-size-by", "height"});
  refused(2, "--tile-size-by", {"--texture", "dots", "--tile-size-by", "size"});
  refused(1, "no values", {"--texture", "dots", "--tile-size-by", "values.csv:b"});
  refused(2, "--outline", {"--outline", "dotted"});
  refused(1, "none.ply", {"--with", "none.ply"});
  refused(2, "out.png", {"--with", "out.png"});
}

TEST_F(StyleTool, TilesFollowValuesAndFlow) {
  const Arguments plain = {"--texture", "dots"};
  const Image dots = picture(plain);
  EXPECT_NE(
      picture({"--texture", "dots", "--texture-by", "height,regions=0,plus@#ff0000,0.1,minus"})
          .pixels,
      dots.pixels);
  EXPECT_NE(picture({"--texture", "dots,shift=0.5"}).pixels, dots.pixels);
  const Image decals = picture({"--texture", "dots", "--tile-size-by", "height"});
  EXPECT_NE(decals.pixels, dots.pixels);
  EXPECT_NE(picture({"--texture", "dots", "--tile-size-by", "height@1..0"}).pixels, decals.pixels);
  EXPECT_NE(picture({"--texture", "dots", "--occlusion", "1", "--ground-shadow"}).pixels,
            dots.pixels);
}

TEST_F(StyleTool, DrawsOutlinesOfStripes) {
  const ToolResult result = run({"stripe", "shape:torus,resolution=24", "--stripes", "8",
                                 "--outline", "solid", "-o", "out.svg", "--size", "96x72"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string svg = content(folder / "out.svg");
  EXPECT_NE(svg.find("<g id=\"surface\" fill=\"#f4efe5\" fill-rule=\"evenodd\">"),
            std::string::npos);
  EXPECT_NE(svg.find("<g id=\"stripes\" fill=\"#1c325a\""), std::string::npos);
  EXPECT_NE(svg.find("<g id=\"lines\" fill=\"none\""), std::string::npos);
  EXPECT_NE(svg.find("stroke-width=\"1.20\""), std::string::npos) << "as wide as in pictures";
  const std::size_t path = svg.find("<path d=\"M") + 10;
  EXPECT_LT(svg.find('c', path), svg.find('"', path)) << "curves";
  // No stripe of so small a picture has a tenth of it.
  const ToolResult cleared = run({"stripe", "shape:torus,resolution=24", "--min-area", "700", "-o",
                                  "large.svg", "--size", "96x72"});
  ASSERT_EQ(cleared.exit_code, 0) << cleared.err;
  const std::string large = content(folder / "large.svg");
  EXPECT_NE(large.find("id=\"surface\""), std::string::npos);
  EXPECT_LT(large.size(), svg.size() / 2);
  const Arguments to_svg = {"stripe", "shape:torus,resolution=24", "-o", "out.svg"};
  for (const Arguments& more : std::vector<Arguments>{
           {"--color-by", "height"}, {"--transparent"}, {"--view", "branches"}}) {
    Arguments arguments = to_svg;
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments).exit_code, 2) << more[0];
  }
}

// Where the tool was built without Cairo, its message says how to have it.
TEST_F(StyleTool, WritesDrawingsAsPdf) {
  const auto draw = [&](const std::string& name) {
    return run({"stripe", "shape:torus,resolution=24", "--stripes", "8", "--outline", "solid", "-o",
                name, "--size", "96x72", "-q"});
  };
  const ToolResult result = draw("out.pdf");
  if (result.exit_code == 2) {
    EXPECT_NE(result.err.find("BRINDLE_CAIRO"), std::string::npos) << result.err;
    return;
  }
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string pdf = content(folder / "out.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_NE(pdf.find("/MediaBox [ 0 0 72 54 ]"), std::string::npos) << "96 pixels are an inch";
  EXPECT_EQ(pdf.find("/CreationDate"), std::string::npos);
  ASSERT_EQ(draw("again.pdf").exit_code, 0);
  EXPECT_EQ(content(folder / "again.pdf"), pdf);
  EXPECT_EQ(run({"curves", "shape:torus,resolution=24", "--stripes", "8", "-o", "lines.pdf",
                 "--size", "96x72", "-q"})
                .exit_code,
            0);
  EXPECT_TRUE(content(folder / "lines.pdf").starts_with("%PDF-"));
}

TEST_F(StyleTool, GlyphsFollowValues) {
  const auto glyphs = [&](const Arguments& more) {
    Arguments arguments = {
        "sample", "shape:torus,resolution=24", "--stripes", "8", "-o", "out.png", "--size",
        "96x72"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_png(folder / "out.png");
  };
  const Image discs = glyphs({"--glyph", "disc"});
  for (const char* shape : {"arrow", "ellipse", "stroke"}) {
    EXPECT_NE(glyphs({"--glyph", shape}).pixels, discs.pixels) << shape;
  }
  ASSERT_EQ(run({"stripe", "shape:sphere,resolution=8", "--transparent", "--size", "64x32", "-o",
                 "ball.png"})
                .exit_code,
            0);
  EXPECT_NE(glyphs({"--glyph", "ball.png"}).pixels, discs.pixels);
  EXPECT_NE(glyphs({"--glyph", "ball.png", "--size-by", "height"}).pixels,
            glyphs({"--glyph", "ball.png"}).pixels);
  const ToolResult missing =
      run({"sample", "shape:torus,resolution=24", "-o", "out.png", "--glyph", "none.png"});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_NE(missing.err.find("none.png"), std::string::npos) << missing.err;
  EXPECT_NE(glyphs({"--size-by", "height@0.1..1"}).pixels, discs.pixels);
  EXPECT_NE(glyphs({"--color-by", "height", "--legend", "none"}).pixels, discs.pixels);
  EXPECT_NE(glyphs({"--glyph-size", "0.4"}).pixels, discs.pixels);
  const Arguments sample = {"sample", "shape:torus,resolution=24", "-o", "out.png"};
  for (const Arguments& more :
       std::vector<Arguments>{{"--size-by", "height@1..-1"},
                              {"--colormap", "magma"},
                              {"--glyph", "cube"},
                              {"--glyph", "ball.png", "--color-by", "height"},
                              {"--size-by", "camera"},
                              {"--glyph-size", "0"}}) {
    Arguments arguments = sample;
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments).exit_code, 2) << more[0];
  }
  EXPECT_EQ(run({"sample", "shape:torus,resolution=24", "--glyph", "disc"}).exit_code, 2);
}

TEST_F(StyleTool, OptionsWithoutEffectAreRefused) {
  ASSERT_EQ(
      run({"stripe", "shape:torus,resolution=12", "-o", "tile.png", "--size", "16x16"}).exit_code,
      0);
  const std::vector<Arguments> refused = {
      {"--width-by", "height", "--stripe-width", "0.4"},
      {"--stripe-width", "2px", "--stripe-width", "0.4"},
      {"--width-by", "height", "--stripe-width", "3px"},
      {"--width-by", "height,tones=0.2..0.8"},
      {"--width-by", "height,cross-hatch=0.5"},
      {"--colormap", "magma"},
      {"--threshold", "1"},
      {"--color-on", "surface", "--width-by", "height"},
      {"--legend", "x"},
      {"--legend", "none", "--width-by", "light"},
      {"--legend", "x", "--legend", "none", "--color-by", "height"},
      {"--flat", "--width-by", "light"},
      {"--outline", "none,hidden=dashed"},
      {"--outline", "none,width=2", "--flat"},
      {"--color-on", "surface", "--color-by", "height", "--between", "nothing"},
      {"--color-on", "motifs", "--color-by", "height"},
      {"--color-on", "strokes", "--color-by", "height", "--texture", "dots"},
      {"--color-on", "surface", "--texture", "dots"},
      {"--color-by", "height", "--texture", "dots", "--between", "nothing"},
      {"--color-on", "motifs", "--color-by", "height", "--texture", "tile.png"},
      {"--color-on", "motifs", "--color-by", "height", "--texture", "dots", "--texture-by",
       "height,regions=0,plus@#ff0000"},
      {"--flat", "--view", "branches"},
      {"--width-by", "height", "--texture", "dots"},
      {"--texture-by", "height,regions=0,plus"},
      {"--texture-by", "height", "--texture", "dots"},
      {"--flat", "--cross"},
      {"--flat", "--points"}};
  for (const Arguments& row : refused) {
    const ToolResult result = run(with(row));
    EXPECT_EQ(result.exit_code, 2) << row[0] << ' ' << row.back();
    EXPECT_NE(result.err.find("has no effect"), std::string::npos) << result.err;
  }
  EXPECT_EQ(run({"stripe", "shape:torus,resolution=24", "--flat"}).exit_code, 2);
  EXPECT_EQ(run({"stripe", "shape:torus,resolution=24", "--flat", "-o", "a.vtp"}).exit_code, 2);
}

}  // namespace
}  // namespace brindle::test

#endif
