#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tool.h"

namespace brindle::test {
namespace {

struct BenchTest : ToolTest {
  /// What `brindle bench --quick` writes with these arguments.
  nlohmann::json report_of(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"bench", "--quick", "--json", "bench.json"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(content(folder / "bench.json"));
  }
};

void expect_positive(const nlohmann::json& spread) {
  EXPECT_GT(spread["min"], 0) << spread;
  EXPECT_GE(spread["median"], spread["min"]) << spread;
  EXPECT_GE(spread["repetitions"], 1) << spread;
}

std::set<std::string> solvers_of(const nlohmann::json& mesh) {
  std::set<std::string> names;
  for (const auto& solver : mesh["solvers"]) names.insert(solver["solver"].get<std::string>());
  return names;
}

TEST_F(BenchTest, MeasuresAllSolversAndFramesOfAMeshAndOfItsFinerCopy) {
  const auto report = report_of({"shape:torus,resolution=24", "--subdivide", "1"});
  ASSERT_EQ(report["meshes"].size(), 2);
  EXPECT_EQ(report["meshes"][1]["vertices"], 4 * report["meshes"][0]["vertices"].get<int>());
  for (const auto& mesh : report["meshes"]) {
    std::set<std::string> expected = {"multilevel", "relaxation 0.05", "relaxation 0.02",
                                      "averaged 0.02"};
#ifdef BRINDLE_HAS_CHOLMOD
    expected.insert({"global 1", "global 20"});
#endif
    EXPECT_EQ(solvers_of(mesh), expected);
    for (const auto& solver : mesh["solvers"]) expect_positive(solver["milliseconds"]["solve"]);
    ASSERT_FALSE(mesh["surroundings"].empty());
    for (const auto& metrics : mesh["surroundings"]) {
      for (const char* what : {"texture", "cross_frame", "cross", "smooth_field"}) {
        expect_positive(metrics["milliseconds"][what]);
      }
    }
    ASSERT_FALSE(mesh["frames"].empty());
    for (const auto& frame : mesh["frames"]) {
      for (const char* stage : {"topology", "couple", "sum", "solve", "total", "measure"}) {
        expect_positive(frame["milliseconds"][stage]);
      }
    }
  }
}

TEST_F(BenchTest, EveryNumberOfThreadsLeavesTheSameBranches) {
  const auto report = report_of({"shape:torus,resolution=24", "--subdivide", "0"});
  const auto& frames = report["meshes"][0]["frames"];
  for (const auto& frame : frames) {
    EXPECT_EQ(frame["branches"], frames[0]["branches"]);
    EXPECT_EQ(frame["energy"], frames[0]["energy"]);
  }
}

TEST_F(BenchTest, RatiosShowBothSides) {
  const auto report = report_of({"shape:torus,resolution=24", "--subdivide", "1"});
  ASSERT_FALSE(report["ratios"].empty());
  bool per_vertex = false;
  for (const auto& ratio : report["ratios"]) {
    for (const char* of : {"median", "min"}) {
      EXPECT_DOUBLE_EQ(ratio[of]["ratio"], ratio[of]["numerator"].get<double>() /
                                               ratio[of]["denominator"].get<double>());
    }
    per_vertex |= ratio["name"].get<std::string>().starts_with("frame per vertex");
  }
  EXPECT_TRUE(per_vertex);
}

TEST_F(BenchTest, FiguresOfThePaperHaveOneRowAMeshAndMethod) {
  const std::vector<std::string> meshes = {"shape:torus,resolution=24",
                                           "shape:sphere,resolution=4"};
  for (const auto& [figure, fields] : {std::pair{"13", 2}, {"14", 1}, {"16", 1}}) {
    const auto report = report_of({meshes[0], meshes[1], "--figure", figure});
    ASSERT_EQ(report["meshes"].size(), 2) << figure;
    for (const auto& mesh : report["meshes"]) {
      EXPECT_EQ(mesh["fields"], fields);
      EXPECT_TRUE(solvers_of(mesh).contains("relaxation 0.02")) << figure;
      EXPECT_EQ(mesh["frames"].size(), 1);
      EXPECT_GT(mesh["colors"]["luby"], 2);
    }
  }
}

TEST_F(BenchTest, LeavesTheGlobalSolverOutAboveALimitAndSaysSo) {
  const auto report =
      report_of({"shape:torus,resolution=24", "--subdivide", "0", "--global-limit", "10"});
  for (const auto& solver : solvers_of(report["meshes"][0])) {
    EXPECT_FALSE(solver.starts_with("global")) << solver;
  }
#ifdef BRINDLE_HAS_CHOLMOD
  ASSERT_EQ(report["notes"].size(), 1);
  EXPECT_NE(report["notes"][0].get<std::string>().find("--global-limit"), std::string::npos);
#endif
}

TEST_F(BenchTest, RefusesWrongUsage) {
  expect_refusal(2, "--figure", {"bench", "--figure", "12"});
  expect_refusal(2, "--repetitions", {"bench", "--repetitions", "0"});
  expect_refusal(2, "--seconds", {"bench", "--seconds", "soon"});
  expect_refusal(2, "shape", {"bench", "-q", "shape:house"});
}

TEST_F(BenchTest, RefusesMeshesThatAreNotThereBeforeItMeasures) {
  expect_refusal(1, "none.ply", {"bench", "-q", "shape:torus,resolution=24", "none.ply"});
}

#ifdef BRINDLE_HAS_GL

TEST_F(BenchTest, MeasuresTheStagesOfFramesOnTheGpu) {
  const auto report =
      report_of({"shape:torus,resolution=100", "--subdivide", "0", "--device", "gpu"});
  EXPECT_EQ(report["device"]["kind"], "gpu");
  EXPECT_GT(report["device"]["copy_bytes_per_second"], 0);
  const auto& mesh = report["meshes"][0];
  EXPECT_EQ(solvers_of(mesh),
            (std::set<std::string>{"multilevel", "relaxation 0.05", "relaxation 0.02"}));
  EXPECT_TRUE(mesh["frames"].empty());
  const auto& frame = mesh["gpu_frames"];
  EXPECT_GT(frame["dispatches"], 10);
  expect_positive(frame["milliseconds"]["device"]);
  expect_positive(frame["milliseconds"]["wall"]);
  expect_positive(frame["milliseconds"]["resident"]);
  expect_positive(frame["milliseconds"]["picture"]);
  std::size_t bytes = 0;
  for (const char* stage : {"load", "couple", "sums", "small levels", "sweeps", "nodes"}) {
    expect_positive(frame["stages"][stage]["milliseconds"]);
    EXPECT_GT(frame["stages"][stage]["bytes"], 0) << stage;
    bytes += frame["stages"][stage]["bytes"].get<std::size_t>();
  }
  EXPECT_EQ(frame["bytes"], bytes);
  EXPECT_NEAR(
      frame["floor_milliseconds"].get<double>(),
      1000 * static_cast<double>(bytes) / report["device"]["copy_bytes_per_second"].get<double>(),
      1e-9);
}

TEST_F(BenchTest, FiguresOfThePaperAreRepeatedOnTheGpu) {
  const auto report = report_of({"shape:torus,resolution=40", "--figure", "13", "--device", "gpu"});
  EXPECT_EQ(report["meshes"][0]["fields"], 2);
  // Where all levels are small, a field takes five: load, couple, sum, descend, back to vertices.
  EXPECT_EQ(report["meshes"][0]["gpu_frames"]["dispatches"], 2 * 5);
}

#endif

}  // namespace
}  // namespace brindle::test
