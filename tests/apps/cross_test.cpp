#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "tool.h"

namespace brindle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

const char* const kSphere = "shape:sphere,resolution=16";

struct Cross : ToolTest {
  Json report(const Arguments& more) const {
    Arguments arguments = {"stripe", kSphere, "--cross", "--report", "report.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(content(folder / "report.json"));
  }
};

TEST_F(Cross, ReportHasTheContractsKeysAndTheTiles) {
  const Json report = this->report({});
  for (const char* key : {"vertices", "triangles", "edges", "solver", "threads", "iterations",
                          "energy", "branches", "field_singularities", "angle_error_mean_deg",
                          "angle_error_share_over_5deg", "spacing_error_mean", "milliseconds"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  EXPECT_GE(report["field_singularities"], 8);
  EXPECT_GE(report["branches"], 16);
  EXPECT_EQ(report["vertices"], 10 * 16 * 16 + 2);
  EXPECT_GT(report["cross"]["angle_distortion_mean_deg"], 0);
}

TEST_F(Cross, NumbersDoNotDependOnThreads) {
  Json one = report({"--threads", "1"}), two = report({"--threads", "2"});
  for (const char* key : {"threads", "milliseconds", "options"}) {
    one.erase(key);
    two.erase(key);
  }
  EXPECT_EQ(one, two);
}

TEST_F(Cross, TakesEveryFieldAndSolver) {
  std::set<double> energies = {report({})["energy"].get<double>()};
  for (const Arguments& options :
       std::vector<Arguments>{{"--direction", "0.3,0.9,0.2"},
                              {"--field", "curvature"},
                              {"--curvature-anchor", "0.3"},
                              {"--feature-anchor", "1,angle=3"},
                              {"--solver", "relaxation"},
                              {"--solver", "averaged"},
                              {"--solver", "multilevel,weights=cotangent"}}) {
    const auto energy = report(options)["energy"].get<double>();
    EXPECT_LT(energy, 0.08) << options[1];
    EXPECT_TRUE(energies.insert(energy).second) << options[1] << " changes nothing";
  }
}

#ifdef BRINDLE_HAS_GL

TEST_F(Cross, DrawsTilesWithNinetyDegreeSymmetryAlone) {
  std::set<std::string> pictures;
  for (const char* tile : {"checker", "dots", "plus"}) {
    report({"--texture", tile, "--output", "a.png", "--size", "160x120"});
    pictures.insert(content(folder / "a.png"));
  }
  EXPECT_EQ(pictures.size(), 3u);
  for (const char* tile : {"arrows", "stripes", "plusminus"}) {
    expect_refusal(2, "90 degrees", {"stripe", kSphere, "--cross", "--texture", tile});
  }
  expect_refusal(2, "--view",
                 {"stripe", kSphere, "--cross", "--view", "angle_error", "--output", "b.png"});
}

TEST_F(Cross, WritesTexturedMeshes) {
  run({"stripe", kSphere, "--cross", "--output", "a.glb", "--output", "a.ply"});
  EXPECT_EQ(content(folder / "a.glb").substr(0, 4), "glTF");
  EXPECT_NE(content(folder / "a.ply").find("phase_v"), std::string::npos);
}

#endif

}  // namespace
}  // namespace brindle::test
