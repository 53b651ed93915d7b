#include <string>

#include <nlohmann/json.hpp>

#include "tool.h"

namespace brindle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

const char* const kPoints = "shape:torus,resolution=64";

struct PointsTool : ToolTest {
  Json report(const std::string& mesh, const Arguments& more = {}) const {
    Arguments arguments = {"stripe", mesh, "--report", "report.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(content(folder / "report.json"));
  }
};

#ifdef BRINDLE_HAS_NANOFLANN

TEST_F(PointsTool, AreTheVerticesOfAMeshIfAskedFor) {
  const Json report = this->report(kPoints, {"--points"});
  EXPECT_EQ(report["triangles"], 0);
  EXPECT_GT(report["edges"], 0);
  EXPECT_LT(report["energy"].get<double>(), 0.1);
  EXPECT_LT(report["angle_error_mean_deg"].get<double>(), 20);
  EXPECT_FALSE(report.contains("branches"));
  EXPECT_FALSE(report.contains("field_singularities"));
}

TEST_F(PointsTool, AreReadBackAsTheyWereWritten) {
  report(kPoints, {"--points", "--output", "a.ply", "--output", "a.vtp"});
  const Json report = this->report("a.ply");
  EXPECT_EQ(report["triangles"], 0);
  EXPECT_EQ(report["vertices"], this->report(kPoints)["vertices"]);
  EXPECT_NE(content(folder / "a.ply").find("property float nx"), std::string::npos);
  EXPECT_NE(content(folder / "a.ply").find("property float phase"), std::string::npos);
}

TEST_F(PointsTool, OfACsvFileWithBadRowsAmongThemAreStriped) {
  std::string text = "x,y,z\nnan,0,0\n0,0,0\n";
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(i % 10) + "," + std::to_string(i / 10) + ",0\n";
  }
  write_text(folder / "a.csv", text);
  const ToolResult result = run({"stripe", "a.csv", "--direction", "1,0,0"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("1 points with coordinates that are not finite"), std::string::npos);
  EXPECT_NE(result.err.find("1 points at the place of another"), std::string::npos);
  EXPECT_LT(report("a.csv", {"--direction", "1,0,0"})["energy"].get<double>(), 1e-5);
}

TEST_F(PointsTool, ThatMakeNoSurfaceAreRefused) {
  write_text(folder / "line.csv", "0,0,0\n1,1,1\n2,2,2\n3,3,3\n");
  expect_refusal(1, "no surface", {"stripe", "line.csv", "--report", "out.json"});
  write_text(folder / "one.csv", "0,0,0\n");
  expect_refusal(1, "no surface", {"stripe", "one.csv", "--report", "out.json"});
  write_text(folder / "two.csv", "1,2,3\n1,2\n");
  expect_refusal(1, "line 2", {"stripe", "two.csv", "--report", "out.json"});
}

TEST_F(PointsTool, AreComparedByAllSolvers) {
  const ToolResult result = run({"compare", kPoints, "--points"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(PointsTool, AreSampledRegularly) {
  const ToolResult result = run({"sample", kPoints, "--points", "--stripes", "20", "--output",
                                 "a.csv", "--report", "report.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json report = Json::parse(content(folder / "report.json"));
  EXPECT_GT(report["samples"], 100);
  EXPECT_EQ(report["nearest_neighbour"]["isolated_double_share"], 0);
  EXPECT_GT(report["nearest_neighbour"]["mean"], 0.8);
  expect_refusal(2, "a.png", {"sample", kPoints, "--points", "--output", "a.png"});
  expect_refusal(2, "--min-distance", {"sample", kPoints, "--points", "--min-distance", "0.2"});
}

#else

TEST_F(PointsTool, NeedNanoflann) {
  expect_refusal(1, "BRINDLE_NANOFLANN", {"stripe", kPoints, "--points", "--report", "out.json"});
}

#endif

TEST_F(PointsTool, RefuseWhatNeedsTriangles) {
  expect_refusal(2, "a.glb", {"stripe", kPoints, "--points", "--output", "a.glb"});
  expect_refusal(2, "--cross", {"stripe", kPoints, "--points", "--cross"});
  expect_refusal(2, "--subdivide", {"stripe", kPoints, "--points", "--subdivide", "1"});
  expect_refusal(2, "--neighbors", {"stripe", kPoints, "--points", "--neighbors", "1"});
}

}  // namespace
}  // namespace brindle::test
