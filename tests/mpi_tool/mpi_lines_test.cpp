#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "mpi_tool/mpi_tool.h"

namespace brindle {
namespace {

using test::content;
using test::MpiTool;
using test::ToolResult;
using test::Words;

struct MpiLines : MpiTool {
  nlohmann::json report(const std::string& name) const {
    return nlohmann::json::parse(content(folder / name));
  }

  /// What 'brindle' makes of the same.
  void run_alone(Words arguments) const {
    arguments.insert(arguments.begin(), {"100", BRINDLE_TOOL_ALONE});
    const ToolResult result = test::run_tool(arguments, folder);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
};

const Words kMesh = {"shape:vessels,resolution=40", "--field", "curvature", "--stripes", "25"};

Words with(const Words& front, const Words& back) {
  Words all = front;
  all.insert(all.end(), back.begin(), back.end());
  return all;
}

TEST_F(MpiLines, CurvesOfOneRankAreThoseOfTheTool) {
  const Words options = {"--lines", "both", "--stripes-v", "12", "--min-length", "10%"};
  const Words mine = with(with({"curves"}, kMesh), options);
  ASSERT_EQ(command_on(1, with(mine, {"--output", "mpi.obj", "--report", "mpi.json"})).exit_code,
            0);
  run_alone(with(mine, {"--output", "tool.obj", "--report", "tool.json"}));
  EXPECT_EQ(content(folder / "mpi.obj"), content(folder / "tool.obj"));
  for (const char* family : {"u", "v"}) {
    const auto mpi = report("mpi.json")[family], tool = report("tool.json")[family];
    for (const auto& [key, value] : mpi.items()) EXPECT_EQ(value, tool[key]) << family << key;
  }
}

TEST_F(MpiLines, SamplesOfOneRankAreThoseOfTheTool) {
  const Words mine = with(with({"sample"}, kMesh), {"--stripes-v", "40", "--min-distance", "0.4"});
  ASSERT_EQ(command_on(1, with(mine, {"--output", "mpi.csv", "--report", "mpi.json"})).exit_code,
            0);
  run_alone(with(mine, {"--output", "tool.csv", "--report", "tool.json"}));
  EXPECT_EQ(content(folder / "mpi.csv"), content(folder / "tool.csv"));
  for (const char* key : {"samples", "doubles_left_out", "branches_u", "branches_v",
                          "nearest_neighbour", "vertices", "edges"}) {
    EXPECT_EQ(report("mpi.json")[key], report("tool.json")[key]) << key;
  }
}

/// Stripes across the torus, all of them rings without an end, are whole on any number of ranks.
TEST_F(MpiLines, RingsAreWholeOnManyRanks) {
  for (const int ranks : {2, 3, 8}) {
    const ToolResult result =
        command_on(ranks, {"curves", "shape:torus,resolution=60", "--field", "curvature",
                           "--curvature-direction", "min", "--stripes", "20", "--output",
                           "rings.csv", "--report", "rings.json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto u = report("rings.json")["u"];
    EXPECT_EQ(u["ends"]["total"], 2 * u["open"].get<std::size_t>());
    EXPECT_GT(u["curves"], 0);
    EXPECT_EQ(report("rings.json")["ranks"]["count"], ranks);
    EXPECT_GT(content(folder / "rings.csv").size(), 1000u);
    // A ring round the tube is no shorter than its circle.
    EXPECT_GT(u["length"].get<double>(), 0.9 * u["closed"].get<double>() * 2 * M_PI * 0.3);
  }
}

TEST_F(MpiLines, SamplesOfManyRanksSayWhoseTheyAre) {
  const ToolResult result = command_on(3, {"sample", "shape:torus,resolution=60", "--stripes", "20",
                                           "--output", "many.vtp", "--report", "many.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const LoadedPoints samples = read_points(folder / "many.vtp");
  EXPECT_EQ(samples.cloud.positions.size(), report("many.json")["samples"]);
  const DataArray& ranks = test::array_of(samples.arrays, "rank");
  int seen[3] = {};
  for (std::size_t row = 0; row < ranks.rows(); ++row) {
    ++seen[test::value<std::int32_t>(ranks, row)];
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

TEST_F(MpiLines, RefuseWhatHasNoEffect) {
  const auto refused = [&](const Words& arguments, const std::string& message) {
    expect_failure(command_on(2, arguments), 2, message);
  };
  refused({"curves", "shape:torus", "--output", "a.png"}, ".obj, .ply, .vtp or .csv");
  refused({"curves", "shape:torus", "--stripes-v", "20"}, "--lines v");
  refused({"curves", "shape:torus", "--join"}, "--join");
  refused({"curves", "shape:torus", "--slack", "0.1"}, "--slack");
  refused({"sample", "shape:torus", "--slack", "0.1"}, "--slack");
  refused({"sample", "shape:torus", "--output", "a.obj"}, ".csv, .ply or .vtp");
  refused({"sample", "shape:torus", "--field", "wind.csv"}, "wind.csv");
  refused({"sample", "shape:nothing"}, "unknown shape");
  expect_failure(command_on(2, {"curves", "nothing.pvtp", "--output", "a.vtp"}), 1, "nothing.pvtp");
  EXPECT_TRUE(listing().empty());
}

TEST_F(MpiLines, EndOnAllRanksWhereTheFileCannotBeWritten) {
  expect_failure(command_on(2, {"curves", "shape:torus", "--output", "none/a.vtp"}), 1, "none");
  expect_failure(command_on(2, {"sample", "shape:torus", "--output", "none/a.vtp"}), 1, "none");
}

}  // namespace
}  // namespace brindle
