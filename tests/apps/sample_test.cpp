#include <algorithm>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "tool.h"

namespace brindle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

struct SampleTool : ToolTest {
  Json report(const Arguments& more, const std::string& mesh = kTorus48) const {
    Arguments arguments = {"sample", mesh, "--report", "report.json", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(content(folder / "report.json"));
  }
};

TEST_F(SampleTool, ReportHasSpacingStatistics) {
  const Json report = this->report({});
  EXPECT_GT(report.at("samples").get<int>(), 100);
  const Json& nearest = report.at("nearest_neighbour");
  EXPECT_NEAR(nearest.at("mean").get<double>(), 1, 0.15);
  EXPECT_LT(nearest.at("deviation").get<double>(), 0.25);
  EXPECT_EQ(nearest.at("isolated_double_share"), 0);
}

TEST_F(SampleTool, WritesWhatTheExtensionSays) {
  const Json report = this->report({"-o", "a.csv", "-o", "a.ply", "-o", "a.vtp"});
  const std::string csv = content(folder / "a.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), report.at("samples").get<int>() + 1);
  EXPECT_TRUE(csv.starts_with("x,y,z,nx,ny,nz,direction_u_x")) << csv.substr(0, 60);
  const std::string count = std::to_string(report.at("samples").get<int>());
  EXPECT_NE(content(folder / "a.ply").find("element vertex " + count + "\n"), std::string::npos);
  EXPECT_NE(content(folder / "a.vtp").find("NumberOfVerts=\"" + count + "\""), std::string::npos);
}

TEST_F(SampleTool, NumbersDoNotDependOnThreads) {
  const auto with = [&](const char* threads) {
    report({"--threads", threads, "-o", "a.csv"});
    return content(folder / "a.csv");
  };
  EXPECT_EQ(with("1"), with("2"));
}

TEST_F(SampleTool, FrequenciesOfBothPatternsGiveTheDensity) {
  const int even = report({"--stripes", "20"}).at("samples");
  const int narrow = report({"--stripes", "20", "--stripes-v", "60"}).at("samples");
  EXPECT_NEAR(narrow, 3 * even, 0.2 * 3 * even);
}

TEST_F(SampleTool, FrequenciesOfTheFieldFileGiveTheDensity) {
  write_text(folder / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  std::string field;
  for (int i = 0; i < 4; ++i) field += "0,1,0,10,30\n";
  write_text(folder / "both.csv", field);
  const auto samples = [&](Arguments more) {
    more.insert(more.end(), {"--field", "both.csv"});
    return report(more, "mesh.obj").at("samples").get<int>();
  };
  EXPECT_NEAR(samples({}), 300, 45);
  EXPECT_NEAR(samples({"--frequency-v", "20"}), 200, 35);
}

TEST_F(SampleTool, SaysThatThereAreNone) {
  // One corner's wave alone reaches through no triangle.
  write_text(folder / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  write_text(folder / "one.csv", "1,0,0\n0,0,0\n0,0,0\n0,0,0\n");
  const ToolResult result =
      run({"sample", "mesh.obj", "--field", "one.csv", "--report", "report.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("no samples"), std::string::npos) << result.err;
  EXPECT_EQ(result.out.find("nearest"), std::string::npos) << result.out;
  EXPECT_EQ(Json::parse(content(folder / "report.json")).at("samples"), 0);
}

TEST_F(SampleTool, FormatsThatHoldNoSamplesNameOneThatDoes) {
  for (const char* name : {"a.obj", "a.glb", "a.svg", "a.pdf", "a"}) {
    expect_refusal(2, ".csv", {"sample", kTorus48, "-o", name});
  }
  expect_refusal(1, "none", {"sample", kTorus48, "-o", "none/a.csv"});
  expect_refusal(1, "none.csv", {"sample", kTorus48, "--field-v", "none.csv", "-o", "a.csv"});
  write_text(folder / "short.csv", "1,0,0,1\n");
  expect_refusal(1, "short.csv", {"sample", kTorus48, "--field-v", "short.csv", "-o", "a.csv"});
}

TEST_F(SampleTool, FullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  for (const char* name : {"full.ply", "full.vtp", "full.csv"}) {
    std::filesystem::create_symlink("/dev/full", folder / name);
    expect_refusal(1, name, {"sample", kTorus48, "-o", name});
  }
}

TEST_F(SampleTool, WrongUsageEndsWithCodeTwo) {
  for (const Arguments& wrong :
       {Arguments{"--min-distance", "-1"}, Arguments{"--min-distance", "near"},
        Arguments{"--stripes-v", "none"}, Arguments{"--frequency-v", "inf"},
        Arguments{"--camera", "30,20"}, Arguments{"--up", "y"}, Arguments{"--size", "64x48"},
        Arguments{"--colors", "#000000,#ffffff"}}) {
    Arguments arguments = {"sample", kTorus48, "-o", "a.csv"};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    expect_refusal(2, wrong.front(), arguments);
  }
}

}  // namespace
}  // namespace brindle::test
