#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "apps/tool.h"

namespace brindle::test {
namespace {

constexpr const char* kTorus24 = "shape:torus,resolution=24";
constexpr const char* kSphere4 = "shape:sphere,resolution=4";

using Runs = std::map<std::string, nlohmann::json>;

/// Each benchmark's part of its name.
std::set<std::string> kinds_of(const Runs& runs) {
  std::set<std::string> kinds;
  for (const auto& [name, run] : runs) kinds.insert(name.substr(0, name.find('/')));
  return kinds;
}

const std::set<std::string> kStages = {"memory",        "topology",
                                       "frame",         "measure",
                                       "surface",       "texture_frame",
                                       "slack",         "cross_frame",
                                       "cross_texture", "slack_in_frame",
                                       "smoothing",     "smoothing_in_frame",
                                       "smooth_field",  "smoothing_of_new_noise"};

std::set<std::string> with(std::set<std::string> names, const std::set<std::string>& more) {
  names.insert(more.begin(), more.end());
  return names;
}

struct BenchTest : ToolTest {
  ToolResult bench(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--benchmark_min_time=0.001", "--benchmark_out=bench.json"});
    return run(arguments);
  }

  /// All results by name, without what Google Benchmark adds to it.
  Runs runs_of(const std::vector<std::string>& arguments) const {
    const ToolResult result = bench(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    Runs runs;
    const nlohmann::json json = report();
    for (const auto& run : json["benchmarks"]) {
      const std::string name = run["name"];
      EXPECT_FALSE(run.value("error_occurred", false)) << run;
      runs[name.substr(0, name.find('/', name.find("/threads:") + 1))] = run;
    }
    return runs;
  }

  void expect_refused(int exit_code, std::string_view message,
                      const std::vector<std::string>& arguments) const {
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << message;
    EXPECT_TRUE(has(result.err, message)) << result.err;
    EXPECT_EQ(result.out, "");
  }

  nlohmann::json report() const { return nlohmann::json::parse(content(folder / "bench.json")); }
};

TEST_F(BenchTest, MeasuresEverythingOnAMeshAndOnItsFinerCopy) {
  const Runs runs = runs_of({kTorus24, "--subdivide", "1", "--benchmark_filter=^[^kpv]"});
  std::set<std::string> expected =
      with(kStages, {"multilevel", "relaxation_0.05", "relaxation_0.02", "averaged_0.02"});
#ifdef BRINDLE_HAS_CHOLMOD
  expected.insert({"global_1", "global_20"});
#endif
  EXPECT_EQ(kinds_of(runs), expected);
  std::map<std::string, std::set<double>> vertices;
  for (const auto& [name, run] : runs) {
    vertices[name.substr(0, name.find('/'))].insert(run["vertices"].get<double>());
    if (name.starts_with("memory")) {
      EXPECT_GT(run["neighborhood_bytes"], 0);
      continue;
    }
    EXPECT_GT(run["min_ms"], 0) << name;
    EXPECT_GE(run["median_ms"], run["min_ms"]) << name;
    for (const char* stage : {"couple_ms", "sum_ms", "solve_ms"}) {
      if (name.starts_with("frame")) {
        EXPECT_GT(run[stage], 0) << name;
      }
    }
    // Google Benchmark's own figure is the mean.
    EXPECT_GE(run["real_time"].get<double>() * (1 + 1e-9), run["min_ms"]) << name;
  }
  for (const auto& [kind, counts] : vertices) {
    ASSERT_EQ(counts.size(), 2) << kind;
    EXPECT_EQ(*counts.rbegin(), 4 * *counts.begin()) << kind;
  }
}

TEST_F(BenchTest, EveryNumberOfThreadsLeavesTheSameBranches) {
  const Runs runs = runs_of({kTorus24, "--subdivide", "0", "--benchmark_filter=^(frame|multi)"});
  std::map<std::string, std::set<std::pair<double, double>>> found;
  for (const auto& [name, run] : runs) {
    found[name.substr(0, name.find('/'))].emplace(run["branches"], run["energy"]);
  }
  ASSERT_EQ(found.size(), 2);
  for (const auto& [kind, results] : found) EXPECT_EQ(results.size(), 1) << kind;
}

TEST_F(BenchTest, TheTableHasRatiosToFramesOfTheSameRun) {
  const ToolResult result = bench({kTorus24, "--subdivide", "0", "--threads", "1",
                                   "--benchmark_filter=^(frame|slack|kernel_copy)"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::map<std::string, double> least;
  const nlohmann::json json = report();
  for (const auto& run : json["benchmarks"]) {
    const std::string name = run["name"];
    least[name.substr(0, name.find('/'))] = run["min_ms"].get<double>();
  }
  std::istringstream lines(result.out);
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    double min = 0, median = 0, per_vertex = 0, ratio = 0;
    char name[100];
    if (std::sscanf(line.c_str(), "%lf %lf %lf %lf %99[a-z_]/", &min, &median, &per_vertex, &ratio,
                    name) != 5) {
      continue;
    }
    ++rows;
    EXPECT_NEAR(ratio, least.at(name) / least.at("frame"), 0.0051) << line;
    EXPECT_NEAR(min, least.at(name), 0.00051) << line;
  }
  EXPECT_EQ(rows, 3);
  EXPECT_TRUE(has(result.out, "/ copy")) << result.out;
}

TEST_F(BenchTest, KernelsAreMeasuredBesideCopies) {
  const Runs runs = runs_of({kTorus24, "--subdivide", "0", "--benchmark_filter=^kernel"});
  for (const char* kernel : {"copy", "gather_portable", "sweep_portable", "sum_portable"}) {
    const auto found = runs.find(std::string("kernel_") + kernel + '/' + kTorus24 + "/threads:1");
    ASSERT_NE(found, runs.end()) << kernel;
    EXPECT_GT(found->second["bytes_per_second"], 0) << kernel;
  }
}

TEST_F(BenchTest, FiguresOfThePaperHaveTheirMethods) {
  for (const std::string figure : {"13", "14", "16"}) {
    const Runs runs = runs_of({kTorus24, kSphere4, "--figure", figure});
    const std::set<std::string> kinds = kinds_of(runs);
    EXPECT_TRUE(kinds.contains("relaxation_0.02")) << figure;
    EXPECT_EQ(kinds.contains("averaged_0.02"), figure == "16");
    EXPECT_FALSE(kinds.contains("slack")) << figure;
    EXPECT_EQ(runs.size(), 2 * kinds.size()) << figure;
    for (const auto& [name, run] : runs) {
      if (name.starts_with("topology")) {
        EXPECT_GT(run["colors_of_the_paper"], 2) << name;
      }
    }
  }
}

TEST_F(BenchTest, LeavesTheGlobalSolverOutAboveALimitAndSaysSo) {
  const ToolResult result = bench(
      {kTorus24, "--subdivide", "0", "--global-limit", "10", "--benchmark_filter=^(frame|global)"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_FALSE(has(content(folder / "bench.json"), "global_")) << content(folder / "bench.json");
#ifdef BRINDLE_HAS_CHOLMOD
  EXPECT_TRUE(has(result.err, "--global-limit 336 includes it")) << result.err;
#endif
}

TEST_F(BenchTest, RefusesWrongUsage) {
  expect_refused(2, "--figure", {"--figure", "12"});
  expect_refused(2, "--figure", {"--figure", "13", "--subdivide", "1"});
  expect_refused(2, "--global-limit", {"--figure", "14", "--global-limit", "100"});
  expect_refused(2, "--gpu", {"--gpu", "--global-limit", "100"});
  expect_refused(2, "--stripes", {"--stripes", "many"});
  expect_refused(2, "--faster", {"--faster"});
  expect_refused(2, "--benchmark_faster", {"--benchmark_faster=1"});
  expect_refused(2, "nothing_of_the_kind", {kTorus24, "--benchmark_filter=nothing_of_the_kind"});
}

TEST_F(BenchTest, RefusesMeshesThatAreNotThereBeforeItMeasures) {
  expect_refused(1, "none.ply", {kTorus24, "none.ply"});
  expect_refused(1, "house", {kTorus24, "shape:house"});
}

TEST_F(BenchTest, HelpNamesItsOptionsAndGoogleBenchmarks) {
  const ToolResult result = run({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* word : {"--figure", "--threads", "--benchmark_filter", "Examples:"}) {
    EXPECT_TRUE(has(result.out, word)) << result.out;
  }
}

#ifdef BRINDLE_HAS_GL

TEST_F(BenchTest, MeasuresPictures) {
  EXPECT_EQ(kinds_of(runs_of({kTorus24, "--subdivide", "0", "--benchmark_filter=^[pv]"})),
            (std::set<std::string>{"picture_interactive", "picture_final", "visible_interactive",
                                   "visible_final"}));
}

TEST_F(BenchTest, MeasuresTheStagesOfFramesOnTheGpu) {
  const Runs runs = runs_of({"shape:torus,resolution=100", "--subdivide", "0", "--gpu"});
  EXPECT_EQ(kinds_of(runs),
            (std::set<std::string>{"frame", "frame_of_resident_input", "picture", "multilevel",
                                   "relaxation_0.05", "relaxation_0.02"}));
  for (const auto& [name, run] : runs) {
    if (!name.starts_with("frame")) continue;
    EXPECT_GT(run["dispatches"], 10);
    EXPECT_GT(run["device_ms"], 0);
    for (const std::string stage : {"load", "couple", "sums", "small levels", "sweeps", "nodes"}) {
      EXPECT_GT(run[stage + "_ms"], 0) << stage;
    }
  }
}

TEST_F(BenchTest, FiguresOfThePaperAreRepeatedOnTheGpu) {
  const Runs runs = runs_of({"shape:torus,resolution=40", "--figure", "13", "--gpu"});
  for (const auto& [name, run] : runs) {
    if (!name.starts_with("frame")) continue;
    // Where all levels are small, a field takes five: load, couple, sum, descend, back to vertices.
    EXPECT_EQ(run["dispatches"], 2 * 5);
  }
}

#endif

}  // namespace
}  // namespace brindle::test
