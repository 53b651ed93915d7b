/// `brindle paths`: a vase in one spiral, lids, files, reports and rejections.
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tool.h"

namespace brindle::test {
namespace {

constexpr const char* kVase = "shape:tube,bend=0,bulge=0.45,resolution=60";

struct PathsTool : ToolTest {
  nlohmann::json report(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "paths");
    arguments.insert(arguments.end(), {"--report", "report.json", "--quiet"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out + result.err, "");
    return nlohmann::json::parse(content(folder / "report.json")).at("paths");
  }
  void refuses(const std::string& why, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"paths", kTorus32});
    expect_refusal(2, why, arguments);
  }
};

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST_F(PathsTool, WindsAVaseInOneSpiralWithoutTravel) {
  const auto paths =
      report({kVase, "--field", "curvature,min", "--order", "spiral", "--spacing", "0.04",
              "--scale", "50:1", "--place", "110,110,0.2", "--output", "vase.gcode"});
  EXPECT_EQ(paths.at("paths"), 1);
  EXPECT_EQ(paths.at("travel"), 0);
  EXPECT_EQ(paths.at("lifts"), 0);
  EXPECT_GT(paths.at("coverage").get<double>(), 0.95);
  const std::string gcode = content(folder / "vase.gcode");
  EXPECT_EQ(count_of(gcode, "\nG0 "), 4u) << "up, over the start, down, and up at the end";
  EXPECT_GT(count_of(gcode, "\nG1 "), 1000u);
}

TEST_F(PathsTool, LeavesOutLids) {
  const std::vector<std::string> spiral = {"shape:sphere,resolution=24",
                                           "--direction",
                                           "0,0,1",
                                           "--order",
                                           "spiral",
                                           "--spacing",
                                           "0.15"};
  std::vector<std::string> arguments = spiral;
  arguments.insert(arguments.begin(), "paths");
  EXPECT_EQ(run(arguments).exit_code, 1) << "a closed surface has no boundary to wind around";
  arguments.insert(arguments.end(), {"--lids", "25"});
  expect_refusal(1, "try --min-length if the rims are jagged", arguments);
  arguments = spiral;
  arguments.insert(arguments.end(), {"--lids", "25", "--min-length", "20%"});
  const auto paths = report(arguments);
  EXPECT_EQ(paths.at("paths"), 1);
  EXPECT_EQ(paths.at("travel"), 0);
  write_text(folder / "square.obj", kSquareObj);
  write_text(folder / "lids.csv", "lid\n1\n0\n");
  write_text(folder / "short.csv", "lid\n1\n");
  const auto half = report({"square.obj", "--spacing", "0.1", "--lids", "lids.csv"});
  const auto whole = report({"square.obj", "--spacing", "0.1"});
  EXPECT_LT(half.at("length").get<double>(), 0.7 * whole.at("length").get<double>());
  expect_refusal(1, "the mesh has 2 triangles", {"paths", "square.obj", "--lids", "short.csv"});
  expect_refusal(1, "all faces are lids", {"paths", "square.obj", "--lids", "20"});
  expect_refusal(1, "no face is a lid", {"paths", "square.obj", "--lids", "20", "--up", "x"});
}

TEST_F(PathsTool, WritesEachKindAndSaysWhatItWrote) {
  for (const char* file : {"a.gcode", "a.dxf", "a.csv", "a.vtp", "a.ply", "a.obj"}) {
    const ToolResult result = run({"paths", kTorus32, "--output", file});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(has(result.out, std::string("wrote ") + file)) << result.out;
    EXPECT_TRUE(has(result.out, "travel ")) << result.out;
  }
  EXPECT_TRUE(has(content(folder / "a.csv"), "kind,curve,closed,x,y,z,nx,ny,nz,direction_x"));
}

TEST_F(PathsTool, TravelIsAtMostThatOfNearestEnds) {
  const auto nearest = report({"shape:vessels,resolution=50", "--stripes", "80", "--connect", "0"});
  EXPECT_LE(nearest.at("travel"), nearest.at("travel_nearest"));
  EXPECT_EQ(nearest.at("lifts").get<int>() + 1, nearest.at("curves").get<int>());
  const auto joined = report({"shape:vessels,resolution=50", "--stripes", "80"});
  EXPECT_GT(joined.at("joins"), 0);
  EXPECT_LT(joined.at("travel"), nearest.at("travel"));
}

TEST_F(PathsTool, RejectsOptionsWithoutEffect) {
  refuses("no G-code is written", {"--axes", "5", "--output", "a.csv"});
  refuses("no G-code is written", {"--gcode", "plain", "--output", "a.dxf"});
  refuses("no machine moves", {"--place", "0,0,0", "--output", "a.csv"});
  refuses("extrudes nothing", {"--gcode", "plain", "--filament", "3", "--output", "a.gcode"});
  refuses("nothing is drawn", {"--camera", "top", "--output", "a.csv"});
  refuses("no height counts", {"--up", "y", "--output", "a.csv"});
  refuses("a spiral is one path", {"--order", "spiral", "--connect", "1"});
  refuses("a spiral winds U", {"--order", "spiral", "--lines", "v"});
  refuses("paths of both would cross", {"--lines", "both"});
  refuses("--least-radius", {"--connect", "1", "--least-radius", "1"});
  refuses("'brindle curves' draws lines", {"--output", "a.svg"});
  refuses("unknown extension '.stl'", {"--output", "a.stl"});
  refuses("degrees above 0 and below 90", {"--lids", "90"});
  refuses("above zero", {"--scale", "0:1", "--output", "a.gcode"});
}

TEST_F(PathsTool, CoversALayerWithFibre) {
  const std::filesystem::path layer =
      std::filesystem::path(BRINDLE_SOURCE) / "../shared/data/layer.obj";
  if (!std::filesystem::exists(layer)) GTEST_SKIP() << "no shared data";
  const auto paths = report({layer.string(), "--spacing", "2", "--min-length", "10"});
  EXPECT_GT(paths.at("coverage").get<double>(), 0.906);
}

}  // namespace
}  // namespace brindle::test
