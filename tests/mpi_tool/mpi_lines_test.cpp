#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <nlohmann/json.hpp>

#include "mpi_tool/mpi_tool.h"

namespace brindle {
namespace {

using test::content;
using test::MpiTool;
using test::ToolResult;
using test::Words;

struct MpiToolLines : MpiTool {
  nlohmann::json report(const std::string& name) const {
    return nlohmann::json::parse(content(folder / name));
  }

  /// What 'brindle' makes of the same.
  void run_alone(Words arguments) const {
    arguments.insert(arguments.begin(), {"1000", BRINDLE_TOOL_ALONE});
    const ToolResult result = test::run_tool(arguments, folder);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
};

/// The sum of errors over triangles is added rank by rank.
void expect_same_error(nlohmann::json& mpi, nlohmann::json& tool) {
  nlohmann::json &error = mpi["frequency_change"]["spacing_error_wanted_mean"],
                 &expected = tool["frequency_change"]["spacing_error_wanted_mean"];
  EXPECT_NEAR(error.get<double>(), expected.get<double>(), 1e-12);
  error = expected;
}

const Words kMesh = {"shape:vessels,resolution=40", "--field", "curvature", "--stripes", "25"};

Words with(const Words& front, const Words& back) {
  Words all = front;
  all.insert(all.end(), back.begin(), back.end());
  return all;
}

TEST_F(MpiToolLines, CurvesAreThoseOfTheTool) {
  const Words options = {"--lines",      "both", "--stripes-v",  "12",
                         "--min-length", "10%",  "--path-width", "1%"};
  for (const Words& more : {Words{}, Words{"--slack", "0.2"}, Words{"--join"}, Words{"--trim", "0"},
                            Words{"--join", "--fair", "0.25"}}) {
    const Words mine = with(with(with({"curves"}, kMesh), options), more);
    run_alone(with(mine, {"--output", "tool.obj", "--report", "tool.json"}));
    for (const int ranks : {1, 3}) {
      const auto result = command_on(ranks, with(mine, {"--plan-below", "262144", "--output",
                                                        "mpi.obj", "--report", "mpi.json"}));
      ASSERT_EQ(result.exit_code, 0) << result.err;
      EXPECT_EQ(content(folder / "mpi.obj"), content(folder / "tool.obj")) << ranks;
      for (const char* family : {"u", "v"}) {
        auto mpi = report("mpi.json")[family], tool = report("tool.json")[family];
        if (ranks > 1 && mpi.contains("frequency_change")) expect_same_error(mpi, tool);
        EXPECT_EQ(mpi, tool) << ranks;
      }
      EXPECT_EQ(report("mpi.json")["ranks"]["count"], ranks);
    }
  }
}

/// Rank 0 draws, too.
TEST_F(MpiToolLines, PicturesOfCurvesAreThoseOfTheTool) {
  const Words options = with({"curves"}, kMesh);
  run_alone(with(options, {"--output", "tool.svg", "--output", "tool.png"}));
  const auto result = command_on(3, with(options, {"--output", "mpi.svg", "--output", "mpi.png"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(content(folder / "mpi.svg"), content(folder / "tool.svg"));
  EXPECT_EQ(content(folder / "mpi.png"), content(folder / "tool.png"));
}

/// Curves go on over creases where phases meet, and end there elsewhere.
TEST_F(MpiToolLines, CurvesOverCreasesAreThoseOfTheTool) {
  const Words options = {"curves", "shape:bracket", "--direction", "1,2,3", "--stripes",
                         "20",     "--offset",      "0.25"};
  run_alone(with(options, {"--output", "tool.obj", "--report", "tool.json"}));
  EXPECT_GT(report("tool.json")["u"]["ends"]["crease"], 0);
  for (const int ranks : {1, 3, 8}) {
    const auto result =
        command_on(ranks, with(options, {"--output", "mpi.obj", "--report", "mpi.json"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(content(folder / "mpi.obj"), content(folder / "tool.obj")) << ranks;
    EXPECT_EQ(report("mpi.json")["u"]["ends"], report("tool.json")["u"]["ends"]) << ranks;
  }
}

/// Ways round handles lead through the pieces of many ranks.
TEST_F(MpiToolLines, LoopsOfManyRanksAreThoseOfTheTool) {
  for (const char* shape : {"shape:torus,resolution=40", "shape:tube", "shape:hemisphere"}) {
    const Words options = {"curves",  shape,  "--field",  "curvature", "--stripes", "20",
                           "--lines", "both", "--offset", "0.25",      "--report"};
    run_alone(with(options, {"tool.json"}));
    for (const int ranks : {1, 3}) {
      const auto result = command_on(ranks, with(options, {"mpi.json"}));
      ASSERT_EQ(result.exit_code, 0) << result.err;
      for (const char* family : {"u", "v"}) {
        const auto expected = report("tool.json")[family]["loops"];
        EXPECT_FALSE(expected.empty()) << shape;
        EXPECT_EQ(report("mpi.json")[family]["loops"], expected) << shape << ' ' << ranks;
      }
    }
  }
}

/// Points that are measured are elsewhere, as curves begin elsewhere; what they say is the same.
TEST_F(MpiToolLines, MeasuresOfCurvesOfManyRanksAreThoseOfTheTool) {
  const Words options = {"curves",         "shape:molecule,resolution=30",
                         "--direction",    "0.3,0.9,0.2",
                         "--stripes",      "25",
                         "--frequency-by", "height",
                         "--path-width",   "1%",
                         "--report"};
  run_alone(with(options, {"tool.json"}));
  const auto alone = report("tool.json")["u"];
  const double once = alone["coverage"], twice = alone["covered_twice"];
  for (const int ranks : {2, 4}) {
    const auto result = command_on(ranks, with(options, {"mpi.json"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto many = report("mpi.json")["u"];
    const auto expect_near = [&](const char* of, const char* key, double share) {
      const double expected = alone[of][key];
      EXPECT_NEAR(many[of][key].get<double>(), expected, share * expected) << of << ' ' << key;
    };
    for (const char* of : {"spacing", "gaps"}) expect_near(of, "measured", 0.001);
    for (const char* key : {"mean", "share_within_10_percent"}) expect_near("spacing", key, 0.001);
    for (const char* key : {"mean", "mean_ratio"}) expect_near("gaps", key, 0.001);
    ASSERT_TRUE(alone["lengths"].contains("longest"));
    for (const auto& [key, value] : alone["lengths"].items()) {
      if (value.is_number()) expect_near("lengths", key.c_str(), 0.001);
    }
    EXPECT_NEAR(many["coverage"].get<double>(), once, 0.004);
    EXPECT_NEAR(many["covered_twice"].get<double>(), twice, 0.004);
  }
}

/// Those that end alone run on to their neighbours, also beyond borders.
TEST_F(MpiToolLines, JoinedCurvesOfManyRanksAreThoseOfTheTool) {
  const Words options = with(with({"curves"}, kMesh), {"--join", "--output"});
  run_alone(with(options, {"tool.vtp", "--report", "tool.json"}));
  const auto alone = report("tool.json")["u"];
  EXPECT_GT(alone["ends_at_neighbours"], 0);
  for (const int ranks : {2, 4}) {
    const auto result = command_on(ranks, with(options, {"mpi.vtp", "--report", "mpi.json"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto many = report("mpi.json")["u"];
    for (const char* key :
         {"curves", "closed", "open", "ends", "joined_ends", "ends_at_neighbours"}) {
      EXPECT_EQ(many[key], alone[key]) << key << " of " << ranks;
    }
    EXPECT_NEAR(many["length"].get<double>(), alone["length"].get<double>(),
                1e-3 * alone["length"].get<double>());
  }
}

/// Where a field has the bits of one process, curves that rank 0 makes of the whole surface do.
TEST_F(MpiToolLines, FairCurvesOfManyRanksAreThoseOfTheTool) {
  const Words options = {"curves",      "shape:vessels,resolution=40",
                         "--direction", "0.3,0.9,0.2",
                         "--stripes",   "25",
                         "--lines",     "both",
                         "--offset",    "0.5",
                         "--join",      "--fair",
                         "0.25",        "--min-length",
                         "3%",          "--output"};
  run_alone(with(options, {"tool.obj", "--report", "tool.json"}));
  const auto alone = report("tool.json");
  EXPECT_GT(alone["u"]["smooth_forks"], 0);
  for (const int ranks : {2, 4}) {
    const auto result = command_on(ranks, with(options, {"mpi.obj", "--report", "mpi.json"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(content(folder / "mpi.obj"), content(folder / "tool.obj")) << ranks;
    for (const char* family : {"u", "v"}) {
      const auto many = report("mpi.json")[family];
      for (const char* key : {"curves", "points", "length", "ends", "smooth_forks", "largest_move",
                              "lengths", "short_curves_left_out"}) {
        EXPECT_EQ(many[key], alone[family][key]) << key << " of " << ranks;
      }
    }
  }
}

/// Moved and reshaped lines, and tubes along them.
TEST_F(MpiToolLines, ShapesOfCurvesAreThoseOfTheTool) {
  for (const Words& more :
       {Words{"--offset", "0.3", "--resample", "1%", "--simplify", "0.1%", "--output"},
        Words{"--offset", "0.5", "--tube-radius", "0.4%", "--tube-sides", "5", "--output"}}) {
    const Words mine = with(with({"curves"}, kMesh), more);
    ASSERT_EQ(command_on(2, with(mine, {"mpi.obj", "--report", "mpi.json"})).exit_code, 0);
    run_alone(with(mine, {"tool.obj", "--report", "tool.json"}));
    EXPECT_EQ(content(folder / "mpi.obj"), content(folder / "tool.obj"));
    const auto mpi = report("mpi.json")["u"], tool = report("tool.json")["u"];
    for (const auto& [key, value] : mpi.items()) EXPECT_EQ(value, tool[key]) << key;
  }
}

/// Rings between the rings of the stripes: as many, and as long on the whole.
TEST_F(MpiToolLines, MovedRingsAreWholeOnManyRanks) {
  const Words rings = {"curves",    "shape:torus,resolution=60",
                       "--field",   "curvature,min",
                       "--stripes", "20",
                       "--output",  "rings.obj"};
  std::size_t curves = 0;
  for (const int ranks : {1, 3}) {
    ASSERT_EQ(
        command_on(ranks, with(rings, {"--offset", "0.25", "--report", "moved.json"})).exit_code,
        0);
    const auto u = report("moved.json")["u"];
    EXPECT_EQ(u["edges_with_jogs"], 0);
    EXPECT_EQ(u["ends"]["total"], 2 * u["open"].get<std::size_t>());
    EXPECT_GT(u["curves"], 0);
    curves += u["curves"].get<std::size_t>();
  }
  EXPECT_GT(curves, 0u);
}

TEST_F(MpiToolLines, SamplesAreThoseOfTheTool) {
  const Words options = {"--stripes-v", "40", "--min-distance", "0.4"};
  for (const Words& more : {Words{}, Words{"--slack", "0.2"}}) {
    const Words mine = with(with(with({"sample"}, kMesh), options), more);
    run_alone(with(mine, {"--output", "tool.csv", "--report", "tool.json"}));
    for (const int ranks : {1, 3}) {
      const auto result = command_on(ranks, with(mine, {"--plan-below", "262144", "--output",
                                                        "mpi.csv", "--report", "mpi.json"}));
      ASSERT_EQ(result.exit_code, 0) << result.err;
      EXPECT_EQ(content(folder / "mpi.csv"), content(folder / "tool.csv")) << ranks;
      for (const char* key : {"samples", "doubles_left_out", "branches_u", "branches_v",
                              "nearest_neighbour", "vertices", "edges"}) {
        EXPECT_EQ(report("mpi.json")[key], report("tool.json")[key]) << key;
      }
    }
  }
}

/// Stripes across the torus, all of them rings without an end, are whole on any number of ranks.
TEST_F(MpiToolLines, RingsAreWholeOnManyRanks) {
  for (const int ranks : {2, 3, 8}) {
    const ToolResult result =
        command_on(ranks, {"curves", "shape:torus,resolution=60", "--field", "curvature,min",
                           "--stripes", "20", "--output", "rings.csv", "--report", "rings.json"});
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

/// A place where a curve crosses a border: the edge and the crossing, and where it is.
using Border = std::tuple<std::int64_t, std::int64_t, std::int32_t>;

/// In a .pvtp every rank has its own lines, whose ends at borders meet those of another one.
TEST_F(MpiToolLines, CurvesInPiecesMeetAtBorders) {
  const Words mine = with(with({"curves"}, kMesh), {"--lines", "both"});
  const ToolResult result =
      command_on(3, with(mine, {"--output", "cut.pvtp", "--report", "cut.json"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  ASSERT_EQ(command_on(3, with(mine, {"--report", "whole.json"})).exit_code, 0);
  std::map<Border, std::vector<std::array<float, 3>>> met;
  for (int r = 0; r < 3; ++r) {
    const LoadedPoints piece = read_points(folder / ("cut_" + std::to_string(r) + ".vtp"));
    const DataArray& edges = test::array_of(piece.arrays, "border_edge");
    const DataArray& crossings = test::array_of(piece.arrays, "border_crossing");
    for (std::size_t row = 0; row < edges.rows(); ++row) {
      const auto [low, high] =
          test::value<std::array<std::int64_t, 2>>({"", NumberType::uint8, 1, edges.bytes}, row);
      EXPECT_EQ(low < 0, high <= low);
      if (low < 0) continue;
      const Vec3& p = piece.cloud.positions[row];
      met[{low, high, test::value<std::int32_t>(crossings, row)}].push_back({p.x(), p.y(), p.z()});
    }
  }
  for (const char* family : {"u", "v"}) {
    const auto cut = report("cut.json")[family], whole = report("whole.json")[family];
    EXPECT_EQ(cut, whole);
  }
  // U and V may cross one edge both.
  std::size_t ends = 0;
  for (const auto& [border, points] : met) {
    ends += points.size();
    EXPECT_EQ(points.size() % 2, 0u);
    for (const auto& point : points) EXPECT_EQ(std::ranges::count(points, point) % 2, 0);
  }
  EXPECT_GT(ends, 40u);
}

TEST_F(MpiToolLines, SamplesInPiecesAreThoseOfOneFile) {
  const Words mine = with({"sample"}, kMesh);
  ASSERT_EQ(command_on(3, with(mine, {"--output", "cut.pvtp"})).exit_code, 0);
  ASSERT_EQ(command_on(3, with(mine, {"--output", "all.vtp"})).exit_code, 0);
  const LoadedPoints all = read_points(folder / "all.vtp");
  std::vector<Vec3> in_pieces;
  for (int r = 0; r < 3; ++r) {
    const std::string name = "cut_" + std::to_string(r) + ".vtp";
    EXPECT_NE(content(folder / "cut.pvtp").find(name), std::string::npos);
    const LoadedPoints piece = read_points(folder / name);
    in_pieces.insert(in_pieces.end(), piece.cloud.positions.begin(), piece.cloud.positions.end());
    for (const DataArray& array : piece.arrays) {
      EXPECT_NE(content(folder / "cut.pvtp").find("Name=\"" + array.name + "\""), std::string::npos)
          << array.name;
    }
  }
  std::vector<Vec3> in_one = all.cloud.positions;
  for (std::vector<Vec3>* positions : {&in_pieces, &in_one}) {
    std::ranges::sort(*positions, {},
                      [](const Vec3& p) { return std::tuple(p.x(), p.y(), p.z()); });
  }
  EXPECT_EQ(in_pieces, in_one);
}

TEST_F(MpiToolLines, RefuseWhatHasNoEffect) {
  const auto refused = [&](const Words& arguments, const std::string& message) {
    expect_failure(command_on(2, arguments), 2, message);
  };
  refused({"curves", "shape:torus", "--winding", "1"}, "in one process");
  refused({"curves", "shape:torus", "--lines", "both", "--wales", "9"}, "in one process");
  refused({"sample", "shape:torus", "--glyph", "arrow"}, "in one process");
  refused({"curves", "shape:torus", "--stripes-v", "20"}, "--lines v");
  refused({"curves", "shape:torus", "--output", "a.pvtp", "--simplify", "1"}, "--simplify");
  refused({"curves", "shape:torus", "--output", "a.pvtp", "--fair", "0.25"}, "--fair");
  refused({"curves", "shape:torus", "--avoid-branches", "avoid.csv"}, "--avoid-branches");
  refused({"sample", "shape:torus", "--output", "a.obj"}, ".csv, .ply or .vtp");
  refused({"curves", "shape:torus", "--tube-sides", "5"}, "--tube-sides");
  refused({"sample", "shape:nothing"}, "unknown shape");
  expect_failure(command_on(2, {"curves", "nothing.pvtp", "--output", "a.vtp"}), 1, "nothing.pvtp");
  EXPECT_TRUE(listing().empty());
}

TEST_F(MpiToolLines, EndOnAllRanksWhereTheFileCannotBeWritten) {
  expect_failure(command_on(2, {"curves", "shape:torus", "--output", "none/a.vtp"}), 1, "none");
  expect_failure(command_on(2, {"sample", "shape:torus", "--output", "none/a.vtp"}), 1, "none");
}

}  // namespace
}  // namespace brindle
