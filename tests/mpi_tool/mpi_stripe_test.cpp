#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <thread>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "brindle/data_arrays.h"
#include "brindle/files.h"
#include "brindle/shapes.h"
#include "mpi_tool/mpi_tool.h"

namespace brindle {
namespace {

using test::array_of;
using test::content;
using test::MpiTool;
using test::run_tool;
using test::ToolResult;
using test::value;
using test::Words;

/// Vertices of several pieces have the same phase in all, and all triangles are there once.
TEST_F(MpiTool, WritesPiecesThatFitTogether) {
  const ToolResult result =
      on(3, {"shape:torus,resolution=60", "--direction", "0.3,0.9,0.2", "--stripes", "30",
             "--output", "out.pvtp", "--report", "out.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto report = nlohmann::json::parse(content(folder / "out.json"));
  EXPECT_EQ(report["ranks"]["count"], 3);
  EXPECT_GT(report["ranks"]["bytes_sent"], 0);
  std::map<std::uint64_t, float> phase_of, at_branch, is_flagged;
  std::size_t triangles = 0, shared = 0, branches = 0;
  for (int r = 0; r < 3; ++r) {
    const std::string name = "out_" + std::to_string(r) + ".vtp";
    EXPECT_NE(content(folder / "out.pvtp").find("<Piece Source=\"" + name + "\"/>"),
              std::string::npos);
    const LoadedMesh loaded = piece(name);
    triangles += loaded.mesh.triangle_count();
    const DataArray& ids = array_of(loaded.arrays.points, "global_id");
    const DataArray& phases = array_of(loaded.arrays.points, "phase");
    const DataArray& flags = array_of(loaded.arrays.points, "branch");
    const DataArray& original = array_of(loaded.arrays.points, "original_id");
    for (std::size_t v = 0; v < loaded.mesh.vertex_count(); ++v) {
      const auto [known, is_new] =
          phase_of.emplace(value<std::uint64_t>(ids, v), value<float>(phases, v));
      shared += !is_new;
      EXPECT_EQ(known->second, value<float>(phases, v));
      const auto id = value<std::uint64_t>(ids, v);
      EXPECT_EQ(value<std::int64_t>(original, v), static_cast<std::int64_t>(id));
      const float flag = value<float>(flags, v);
      EXPECT_EQ(is_flagged.emplace(id, flag).first->second, flag);
    }
    const DataArray& ends = array_of(loaded.arrays.cells, "branch");
    for (std::size_t t = 0; t < loaded.mesh.triangle_count(); ++t) {
      branches += value<std::uint8_t>(ends, t);
      for (const Index v : loaded.mesh.triangles[t]) {
        float& flag = at_branch[value<std::uint64_t>(ids, v)];
        flag = std::max(flag, static_cast<float>(value<std::uint8_t>(ends, t)));
      }
    }
  }
  EXPECT_EQ(is_flagged, at_branch);
  EXPECT_EQ(triangles, report["triangles"]);
  EXPECT_EQ(phase_of.size(), report["vertices"]);
  EXPECT_EQ(branches, report["branches"]);
  EXPECT_GT(shared, 0u);
}

/// A mesh that rank 0 reads whole, shapes in parts, and triangles that are split.
TEST_F(MpiTool, OfOneRankWritesWhatTheToolWrites) {
  const Words meshes[] = {{"shape:vessels,resolution=40"},
                          {"shape:vessels,resolution=40", "--normal-radius", "2%"},
                          {"shape:torus,resolution=40", "--subdivide", "1"},
                          {"shape:sphere,resolution=12"},
                          {"shape:box,resolution=8", "--subdivide", "2"},
                          {"shape:bracket"},
                          {"shape:gear", "--subdivide", "1"},
                          {"shape:gear", "--crease-angle", "100"},
                          {"shape:sheets,resolution=12"},
                          {"shape:box,resolution=9", "--feature-anchor", "2,radius=6%"}};
  for (const Words& mesh : meshes) {
    Words mine = mesh;
    mine.insert(mine.end(), {"--field", "curvature", "--along", "--stripes", "25"});
    Words tools = mine;
    mine.insert(mine.end(), {"--output", "mpi.pvtp", "--report", "mpi.json"});
    ASSERT_EQ(on(1, mine).exit_code, 0);
    tools.insert(tools.begin(), {"1000", BRINDLE_TOOL_ALONE, "stripe"});
    tools.insert(tools.end(), {"--output", "tool.vtp", "--report", "tool.json"});
    ASSERT_EQ(run_tool(tools, folder).exit_code, 0);
    const LoadedMesh one = piece("mpi_0.vtp"), other = piece("tool.vtp");
    // `global_id` is the one that the tool does not have.
    EXPECT_EQ(one.arrays.points.size(), other.arrays.points.size() + 1);
    for (const DataArray& array : other.arrays.points) {
      EXPECT_EQ(array_of(one.arrays.points, array.name).bytes, array.bytes) << array.name;
    }
    EXPECT_EQ(array_of(one.arrays.cells, "corner_phase").bytes,
              array_of(other.arrays.cells, "corner_phase").bytes);
    const auto mpi = nlohmann::json::parse(content(folder / "mpi.json"));
    const auto tool = nlohmann::json::parse(content(folder / "tool.json"));
    for (const auto& [key, value] : tool.items()) {
      if (key == "milliseconds" || key == "options") continue;
      EXPECT_EQ(mpi[key], value) << key;
    }
  }
}

/// Vertices on creases have copies, with the rows of the ones that they copy, and the phases of one
/// process whatever the number of ranks.
TEST_F(MpiTool, SplitsCreasesAsTheToolDoes) {
  const Mesh gear = make_shape("gear");
  std::string field;
  for (const Vec3& p : gear.positions) field += p.x() > 0 ? "1,0.2,0.1\n" : "0.1,1,0.3\n";
  test::write_text(folder / "field.csv", field);
  const Words runs[] = {
      {"shape:bracket", "--direction", "1,2,3"},
      {"shape:bracket", "--field", "curvature", "--slack", "0.2"},
      {"shape:gear", "--subdivide", "1", "--plan-below", "0"},
      {"shape:gear", "--field", "field.csv", "--solver", "multilevel,weights=cotangent"}};
  for (const Words& run : runs) {
    Words tools = run;
    std::erase(tools, "--plan-below");
    std::erase(tools, "0");
    tools.insert(tools.begin(), {"1000", BRINDLE_TOOL_ALONE, "stripe"});
    tools.insert(tools.end(), {"--output", "tool.vtp", "--report", "tool.json"});
    ASSERT_EQ(run_tool(tools, folder).exit_code, 0);
    const LoadedMesh tool = piece("tool.vtp");
    const auto expected = nlohmann::json::parse(content(folder / "tool.json"));
    EXPECT_GT(expected["crease_vertices"], 0);
    for (const int ranks : {1, 3, 8}) {
      Words mine = run;
      mine.insert(mine.end(), {"--output", "mpi.pvtp", "--report", "mpi.json"});
      const ToolResult result = on(ranks, mine);
      ASSERT_EQ(result.exit_code, 0) << result.err;
      std::vector<LoadedMesh> parts;
      std::size_t triangles = 0;
      for (int r = 0; r < ranks; ++r) {
        parts.push_back(piece("mpi_" + std::to_string(r) + ".vtp"));
        triangles += parts.back().mesh.triangle_count();
      }
      SCOPED_TRACE(run[0] + " " + std::to_string(ranks));
      test::expect_rows_of_whole(tool, expected["vertices"], parts,
                                 {"phase", "direction", "original_id", "branch"});
      EXPECT_EQ(triangles, tool.mesh.triangle_count());
      const auto report = nlohmann::json::parse(content(folder / "mpi.json"));
      for (const char* key : {"vertices", "edges", "crease_vertices", "branches", "energy",
                              "crease_slip_mean_deg", "crease_slip_share"}) {
        EXPECT_EQ(report[key], expected[key]) << run[0] << ' ' << key << ' ' << ranks;
      }
    }
  }
}

/// A CSV file of --avoid-branches for a torus: 1 for every third vertex.
void write_penalties(const std::filesystem::path& path, std::size_t rows) {
  std::string text;
  for (std::size_t row = 0; row < rows; ++row) text += row % 3 == 0 ? "1\n" : "0\n";
  test::write_text(path, text);
}

TEST_F(MpiTool, OfOneRankYieldsAndWeighsAsTheToolDoes) {
  const Words words = {"shape:torus,resolution=40",
                       "--direction",
                       "0.3,0.9,0.2",
                       "--solver",
                       "multilevel,weights=cotangent",
                       "--slack",
                       "0.25",
                       "--avoid-branches",
                       "avoid.csv"};
  Words mine = words, tools = words;
  mine.insert(mine.end(), {"--output", "mpi.pvtp", "--report", "mpi.json"});
  tools.insert(tools.begin(), {"1000", BRINDLE_TOOL_ALONE, "stripe"});
  tools.insert(tools.end(), {"--output", "tool.vtp", "--report", "tool.json"});
  write_penalties(folder / "avoid.csv", make_shape("torus,resolution=40").vertex_count());
  ASSERT_EQ(on(1, mine).exit_code, 0);
  ASSERT_EQ(run_tool(tools, folder).exit_code, 0);
  const LoadedMesh one = piece("mpi_0.vtp"), other = piece("tool.vtp");
  for (const char* name : {"phase", "frequency", "frequency_wanted"}) {
    EXPECT_EQ(array_of(one.arrays.points, name).bytes, array_of(other.arrays.points, name).bytes)
        << name;
  }
  const auto mpi = nlohmann::json::parse(content(folder / "mpi.json"));
  const auto tool = nlohmann::json::parse(content(folder / "tool.json"));
  EXPECT_EQ(mpi["frequency_change"], tool["frequency_change"]);
  EXPECT_TRUE(mpi["milliseconds"].contains("frequency"));
}

TEST_F(MpiTool, WritesFrequenciesThatYield) {
  const std::size_t count = make_shape("torus,resolution=200").vertex_count();
  write_penalties(folder / "avoid.csv", count);
  const ToolResult result =
      on(3, {"shape:torus,resolution=200", "--direction", "0.3,0.9,0.2", "--stripes", "30",
             "--slack", "0.2", "--avoid-branches", "avoid.csv", "--frames", "2", "--plan-below",
             "0", "--output", "out.pvtp", "--report", "out.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto report = nlohmann::json::parse(content(folder / "out.json"));
  EXPECT_TRUE(report["frequency_change"].contains("branches_in_avoided_area"));
  EXPECT_GT(report["frames"]["frequency_halo_bytes"], 0);
  EXPECT_GE(report["frames"]["frequency_bytes_sent"], report["frames"]["frequency_halo_bytes"]);
  EXPECT_NE(content(folder / "out.pvtp").find("Name=\"frequency_wanted\""), std::string::npos);
  std::map<std::uint64_t, float> frequency_of;
  float most = 1;
  for (int r = 0; r < 3; ++r) {
    const LoadedMesh loaded = piece("out_" + std::to_string(r) + ".vtp");
    const DataArray& ids = array_of(loaded.arrays.points, "global_id");
    const DataArray& chosen = array_of(loaded.arrays.points, "frequency");
    const DataArray& wanted = array_of(loaded.arrays.points, "frequency_wanted");
    for (std::size_t v = 0; v < loaded.mesh.vertex_count(); ++v) {
      const auto id = value<std::uint64_t>(ids, v);
      const float ratio = value<float>(chosen, v) / value<float>(wanted, v);
      most = std::max(most, ratio);
      EXPECT_LE(ratio, (id % 3 == 0 ? 1.6f : 1.2f) * (1 + 1e-6f));
      const auto [known, is_new] = frequency_of.emplace(id, value<float>(chosen, v));
      EXPECT_EQ(known->second, value<float>(chosen, v));
    }
  }
  EXPECT_EQ(frequency_of.size(), count);
  EXPECT_GT(most, 1.2f);
}

TEST_F(MpiTool, RefusesPenaltiesThatDoesNotFit) {
  write_penalties(folder / "avoid.csv", 7);
  expect_failure(on(2, {"shape:torus", "--slack", "0.2", "--avoid-branches", "avoid.csv"}), 1,
                 "avoid.csv");
  expect_failure(on(2, {"shape:torus", "--avoid-branches", "avoid.csv"}), 2, "--avoid-branches");
  expect_failure(on(2, {"shape:torus", "--slack", "-1"}), 2, "--slack");
}

TEST_F(MpiTool, MeasuresFrames) {
  const ToolResult result =
      on(2, {"shape:torus,resolution=60", "--frames", "3", "--report", "out.json", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  const auto frames = nlohmann::json::parse(content(folder / "out.json"))["frames"];
  EXPECT_EQ(frames["count"], 3);
  EXPECT_GE(frames["bytes_sent"], frames["halo_bytes"]);
  EXPECT_GE(frames["imbalance"], 1);
}

/// What a run of more ranks has left under the same name, and nothing else.
TEST_F(MpiTool, TakesOlderPiecesAway) {
  const Words words = {"shape:torus,resolution=20", "--output", "out.pvtp", "--quiet"};
  ASSERT_EQ(on(4, words).exit_code, 0);
  test::write_text(folder / "out_7.vtp", "of somebody else");
  ASSERT_EQ(on(2, words).exit_code, 0);
  EXPECT_EQ(listing(), (std::set<std::string>{"out.pvtp", "out_0.vtp", "out_1.vtp", "out_7.vtp"}));
  // Where they are input, nothing is written.
  ASSERT_EQ(on(4, words).exit_code, 0);
  const auto result = on(2, {"out_3.vtp", "--output", "out.pvtp"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(std::filesystem::exists(folder / "out_3.vtp"));
}

TEST_F(MpiTool, RefusesWhatIsForOneProcess) {
  expect_failure(on(2, {"shape:torus", "--texture", "dots"}), 2, "without mpirun");
  expect_failure(on(2, {"shape:torus", "--subdivide", "1,rounded"}), 2,
                 "--subdivide ...,rounded: it needs the whole surface");
  expect_failure(on(2, {"shape:torus", "--output", "a.vtp"}), 2, ".pvtp");
  expect_failure(on(2, {"shape:torus", "--solver", "relaxation"}), 2, "--solver");
  expect_failure(on(2, {"shape:nothing"}), 2, "unknown shape");
}

TEST_F(MpiTool, RefusesCommandsOfOneProcessOnce) {
  expect_failure(command_on(3, {"info", "shape:torus"}), 2, "'brindle info' runs in one process");
  expect_failure(command_on(2, {"animate", "shape:torus", "--output", "a%03d.png"}), 2,
                 "without mpirun");
  expect_failure(command_on(2, {"strip", "shape:torus"}), 2, "did you mean 'stripe'");
}

TEST_F(MpiTool, PrintsHelpOnce) {
  const ToolResult result = command_on(2, {"stripe", "--help"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::size_t usage = result.out.find("Usage");
  EXPECT_NE(usage, std::string::npos) << result.out;
  EXPECT_EQ(result.out.find("Usage", usage + 1), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("--plan-below"), std::string::npos);
}

/// Also what ranks do not write, and without a launcher nothing has pieces.
TEST_F(MpiTool, OneProcessUnderALauncherIsTheTool) {
  const Words words = {
      "stripe", "shape:torus,resolution=20", "--output", "a.png", "--output", "a.ply", "--threads",
      "1"};
  const ToolResult under = command_on(1, words);
  ASSERT_EQ(under.exit_code, 0) << under.err;
  const std::string picture = content(folder / "a.png"), mesh = content(folder / "a.ply");
  Words alone = {"1000", BRINDLE_TOOL_ALONE};
  alone.insert(alone.end(), words.begin(), words.end());
  ASSERT_EQ(run_tool(alone, folder).exit_code, 0);
  EXPECT_EQ(picture, content(folder / "a.png"));
  EXPECT_EQ(mesh, content(folder / "a.ply"));
  expect_failure(
      run_tool({"1000", BRINDLE_TOOL_ALONE, "stripe", "shape:torus", "--output", "out.pvtp"},
               folder),
      2, "start brindle by mpirun");
}

TEST_F(MpiTool, EndsAllRanksWhereAFileCannotBeRead) {
  expect_failure(on(2, {"nothing.ply", "--output", "out.pvtp"}), 1, "nothing.ply");
  test::write_text(folder / "bad.ply", "ply\nno");
  expect_failure(on(2, {"bad.ply", "--output", "out.pvtp"}), 1, "bad.ply");
}

TEST_F(MpiTool, EndsAllRanksWhereOneCannotWrite) {
  std::filesystem::create_directories(folder / "out_1.vtp");
  expect_failure(on(2, {"shape:torus,resolution=30", "--output", "out.pvtp"}), 1, "out_1.vtp");
  EXPECT_FALSE(std::filesystem::exists(folder / "out_0.vtp"));
}

/// Until the tool catches Ctrl-C, as it does while it works. So does the shell that becomes it.
constexpr const char* kWhenItWorks =
    "(until grep -qx brindle /proc/$$/comm && "
    "grep -q 'SigCgt:.*[2367abef]$' /proc/$$/status; do sleep 0.1; done; kill ";

TEST_F(MpiTool, EndsAllRanksWhereOneIsCancelled) {
  const Words arguments = {"shape:torus,resolution=300", "--solver", "multilevel,cycles=9999",
                           "--output", "out.pvtp"};
  expect_failure(with_trouble(std::string(kWhenItWorks) + "-INT $$) &", arguments, arguments), 1,
                 "cancelled");
}

TEST_F(MpiTool, EndsAllRanksWhereOneIsKilled) {
  const Words arguments = {"shape:torus,resolution=300", "--solver", "multilevel,cycles=9999",
                           "--output", "out.pvtp"};
  const ToolResult result =
      with_trouble(std::string(kWhenItWorks) + "-KILL $$) &", arguments, arguments);
  EXPECT_NE(result.exit_code, 0);
  EXPECT_NE(result.exit_code, 124) << "hangs";
  EXPECT_FALSE(std::filesystem::exists(folder / "out.pvtp"));
}

/// So a rank that is killed while it or another one writes leaves nothing behind.
TEST_F(MpiTool, PiecesHaveNoNamesUntilAllAreWhole) {
  const int unnamed = open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (unnamed < 0) GTEST_SKIP() << "this file system knows no files without names";
  close(unnamed);
  std::set<std::string> seen;
  std::atomic<bool> done = false;
  std::thread watch([&] {
    while (!done) {
      for (const auto& file : std::filesystem::directory_iterator(folder)) {
        seen.insert(file.path().filename().string());
      }
    }
  });
  const ToolResult result =
      on(2, {"shape:torus,resolution=300", "--output", "out.pvtp", "--quiet"});
  done = true;
  watch.join();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  seen.merge(listing());
  EXPECT_EQ(seen, (std::set<std::string>{"out.pvtp", "out_0.vtp", "out_1.vtp"}));
}

}  // namespace
}  // namespace brindle
