#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <regex>
#include <string>

#include <nlohmann/json.hpp>

#include "brindle/version.h"
#include "tool.h"

namespace brindle::test {
namespace {

TEST_F(ToolTest, HelpHasExamples) {
  EXPECT_TRUE(has(run({"--help"}).out, "Examples:"));
  for (const char* command : {"stripe", "compare", "curves", "paths", "sample", "animate", "info",
#ifdef BRINDLE_HAS_GL
                              "render",
#endif
                              "gallery"}) {
    const ToolResult result = run({command, "--help"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_TRUE(has(result.out, std::string("brindle ") + command)) << result.out;
    EXPECT_TRUE(has(result.out, "Examples:")) << result.out;
  }
}

TEST_F(ToolTest, BuildsWithoutMpiRejectLaunchersOfSeveralProcesses) {
  if (has(run({"--version"}).out, "MPI")) GTEST_SKIP() << "this build has MPI";
  for (const char* count : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    setenv(count, "2", 1);
    expect_refusal(1, "-DBRINDLE_MPI=ON", {"stripe", "shape:torus", "--output", "a.png"});
    setenv(count, "1", 1);
    EXPECT_EQ(run({"info", kTorus16}).exit_code, 0);
    unsetenv(count);
  }
}

// But those of help.
std::size_t option_count(const std::string& help) {
  static const std::regex option("\n  -");
  return static_cast<std::size_t>(
             std::distance(std::sregex_iterator(help.begin(), help.end(), option), {})) -
         2;
}

TEST_F(ToolTest, HelpIsShortAndNamesTheWholeOne) {
  for (const std::string command : {"stripe", "compare", "curves", "sample", "animate"}) {
    const std::string some = run({command, "--help"}).out, all = run({command, "--help-all"}).out;
    EXPECT_LE(option_count(some), 30u) << some;
    EXPECT_TRUE(has(some, "'brindle " + command + " --help-all' lists " +
                              std::to_string(option_count(all) - option_count(some)) + " more"))
        << some;
    EXPECT_FALSE(has(all, "more options")) << all;
  }
}

// What is written comes first, how it is computed last.
TEST_F(ToolTest, HelpHasGroups) {
  const std::string all = run({"stripe", "--help-all"}).out;
  EXPECT_LT(all.find("\nOutput:\n"), all.find("\nSurface:\n"));
  EXPECT_GT(all.find("\nSolver:\n"), all.find("\nPicture:\n"));
  EXPECT_LT(all.find("\nOutput:\n  -o,--output"), all.find("\nOptions:\n  -h,--help"));
}

TEST_F(ToolTest, HelpSaysHowCommandsEnd) {
  const std::string help = run({"--help"}).out;
  for (const char* part : {"0 if the job is done", "130 if Ctrl-C"}) {
    EXPECT_TRUE(has(help, part)) << help;
  }
}

TEST_F(ToolTest, VersionNamesTheProgramAndItsParts) {
  const ToolResult result = run({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("brindle " BRINDLE_VERSION "\nbuilt in: ")) << result.out;
#ifdef BRINDLE_HAS_TBB
  EXPECT_TRUE(has(result.out, "oneTBB")) << result.out;
#else
  EXPECT_FALSE(has(result.out, "oneTBB")) << result.out;
#endif
}

TEST_F(ToolTest, ShapesAreListed) {
  const ToolResult result = run({"--shapes"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(has(result.out, "torus")) << result.out;
}

TEST_F(ToolTest, CompareHasOneRowASolver) {
  const ToolResult result =
      run({"compare", "shape:torus,resolution=48", "--direction", "0,0,1", "--json", "all.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(content(folder / "all.json"));
  std::set<std::string> solvers;
  for (const auto& report : json) {
    solvers.insert(report["solver"].get<std::string>());
    EXPECT_TRUE(has(result.out, report["solver"].get<std::string>())) << result.out;
  }
  std::set<std::string> expected = {"averaged", "multilevel", "relaxation"};
#ifdef BRINDLE_HAS_CHOLMOD
  expected.insert("global");
#endif
  EXPECT_EQ(solvers, expected);
}

TEST_F(ToolTest, InfoCountsAClosedSurface) {
  const ToolResult result = run({"info", "shape:sphere,resolution=4"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.out, "vertices      162\n")) << result.out;
  EXPECT_TRUE(has(result.out, "triangles     320\n")) << result.out;
  EXPECT_TRUE(has(result.out, "480, 0 on a boundary, 0 non-manifold")) << result.out;
  EXPECT_TRUE(has(result.out, "components    1\n")) << result.out;
  EXPECT_TRUE(has(result.out, "orientable, wound alike")) << result.out;
}

TEST_F(ToolTest, InfoKnowsAMoebiusStrip) {
  EXPECT_TRUE(has(run({"info", "shape:mobius,resolution=6"}).out, "not orientable"));
}

TEST_F(ToolTest, InfoKnowsNonManifoldEdges) {
  const ToolResult result = run({"info", "shape:sheets,resolution=4"});
  EXPECT_FALSE(has(result.out, " 0 non-manifold")) << result.out;
}

TEST_F(ToolTest, InfoCountsPieces) {
  EXPECT_TRUE(has(run({"info", "shape:pieces,count=4"}).out, "components    4\n"));
}

TEST_F(ToolTest, InfoSaysWhereTrianglesAreWoundAgainstEachOther) {
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n");
  EXPECT_TRUE(has(run({"info", "a.obj"}).out, "but not wound alike"));
}

TEST_F(ToolTest, InfoReportsRepairs) {
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n");
  const ToolResult result = run({"info", "a.obj"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.out, "triangles     1\n")) << result.out;
  EXPECT_FALSE(has(result.out, "none needed")) << result.out;
}

TEST_F(ToolTest, OutputsMayComeBeforeTheMesh) {
  for (const char* command : {"stripe", "curves", "sample"}) {
    const ToolResult result = run({command, "-o", "a.ply", "--output", "b.ply",
                                   "shape:torus,resolution=48", "--direction", "0,0,1", "-q"});
    EXPECT_EQ(result.exit_code, 0) << command << ": " << result.err;
    for (const char* name : {"a.ply", "b.ply"}) {
      EXPECT_TRUE(std::filesystem::remove(folder / name)) << command << ", " << name;
    }
  }
}

TEST_F(ToolTest, AnEmptyNameIsNoMesh) {
  for (const char* command : {"stripe", "compare", "curves", "sample", "animate", "info"}) {
    expect_refusal(2, "MESH", {command, ""});
  }
}

}  // namespace
}  // namespace brindle::test
