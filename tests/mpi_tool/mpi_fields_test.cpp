// Fields of files, frequencies that follow values, and the input's own arrays.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/shapes.h"
#include "mpi_tool/mpi_tool.h"

namespace brindle {
namespace {

using test::array_of;
using test::content;
using test::MpiTool;
using test::Words;
using test::write_text;

/// A sphere with arrays of all sorts, and two vertices beside each other that are joined.
Mesh sphere_with_seam() {
  Mesh mesh = make_shape("sphere,resolution=10");
  for (const Index v : {7u, 100u}) {
    mesh.positions.push_back(mesh.positions[v]);
    const auto copy = static_cast<Index>(mesh.vertex_count() - 1);
    for (std::size_t t = 0; t < mesh.triangle_count(); t += 2) {
      for (Index& corner : mesh.triangles[t]) corner = corner == v ? copy : corner;
    }
  }
  return mesh;
}

struct MpiToolFields : MpiTool {
  Mesh mesh = sphere_with_seam();
  std::mt19937 random{5};

  float number() { return std::uniform_real_distribution<float>(-1, 1)(random); }

  std::vector<Vec3> vectors(std::size_t count) {
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < count; ++i) result.emplace_back(number(), number(), number());
    result[3].x() = NAN;
    return result;
  }

  std::vector<double> positive(std::size_t count) {
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(6 + number());
    return result;
  }

  void write_mesh_with_arrays() {
    std::vector<double> densities = positive(mesh.vertex_count()), tensors;
    densities[5] = NAN;
    std::vector<std::int16_t> labels;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      labels.push_back(static_cast<std::int16_t>(v % 7));
    }
    for (std::size_t i = 0; i < 6 * mesh.triangle_count(); ++i) {
      tensors.push_back(static_cast<double>(number()));
    }
    write_mesh(folder / "in.vtp", mesh,
               std::vector<DataArray>{make_data_array("density", 1, densities),
                                      make_data_array("label", 1, labels)},
               std::vector<DataArray>{
                   make_data_array("flow", std::span<const Vec3>(vectors(mesh.triangle_count()))),
                   make_data_array("stress", 6, tensors),
                   make_data_array("load", 1, positive(mesh.triangle_count()))});
  }

  /// Rows of numbers, the first three a vector.
  void write_rows(const std::string& name, const std::string& head, std::size_t rows,
                  std::size_t columns) {
    std::ostringstream text;
    text.precision(9);
    text << head;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t c = 0; c < columns; ++c) {
        text << (c > 0 ? "," : "");
        if (row == 4 && c < 3) {
          text << "nan";
        } else {
          text << (c < 3 ? number() : 6 + number());
        }
      }
      text << '\n';
    }
    write_text(folder / name, text.str());
  }

  nlohmann::json report(const std::string& name) const {
    return nlohmann::json::parse(content(folder / name));
  }

  LoadedMesh run_alone(const std::string& input, const Words& options) const {
    Words tool = {"100",      BRINDLE_TOOL_ALONE, "stripe",    input,    "--output",
                  "tool.vtp", "--report",         "tool.json", "--quiet"};
    tool.insert(tool.end(), options.begin(), options.end());
    const auto result = test::run_tool(tool, folder);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return piece("tool.vtp");
  }

  void run_ranks(int ranks, const std::string& input, const Words& options) const {
    Words mine = {input, "--output", "mpi.pvtp", "--report", "mpi.json", "--quiet"};
    mine.insert(mine.end(), options.begin(), options.end());
    const auto result = on(ranks, mine);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }

  /// Of these and all that the input has. `whole` is the tool's, or that of one rank.
  void expect_same_rows(const LoadedMesh& whole, int ranks, const Words& names) const {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    std::vector<LoadedMesh> parts;
    for (int r = 0; r < ranks; ++r) parts.push_back(piece("mpi_" + std::to_string(r) + ".vtp"));
    const std::size_t copies = report("mpi.json").value("crease_vertices", std::size_t{0});
    test::expect_rows_of_whole(whole, whole.mesh.vertex_count() - copies, parts, names);
  }

  /// One rank has all that the tool has; more have the same waves, and report the same of them.
  void expect_agreement(const std::string& input, const Words& options,
                        const std::vector<std::string>& arrays) const {
    std::string words;
    for (const std::string& option : options) words += option + " ";
    SCOPED_TRACE(input + " " + words);
    const LoadedMesh whole = run_alone(input, options);
    Words names = {"direction", "frequency"};
    names.insert(names.end(), arrays.begin(), arrays.end());
    for (const int ranks : {1, 3}) {
      run_ranks(ranks, input, options);
      expect_same_rows(whole, ranks, names);
      const auto mpi = report("mpi.json"), tool = report("tool.json");
      for (const auto& [key, value] : tool.items()) {
        const bool of_waves = key.starts_with("vertices") || key.starts_with("frequency_") ||
                              key.starts_with("field_") || key.starts_with("edges");
        if (key == "milliseconds" || key == "options" || key == "threads") continue;
        if (ranks > 1 && !of_waves) continue;
        EXPECT_EQ(mpi.value(key, nlohmann::json()), value) << key;
      }
      if (ranks == 1) {
        expect_same_rows(whole, 1, {"phase", "sin_phase", "valid"});
        for (const DataArray& array : whole.arrays.cells) {
          EXPECT_EQ(array_of(piece("mpi_0.vtp").arrays.cells, array.name), array);
        }
      }
    }
  }
};

TEST_F(MpiToolFields, TakesRowsOfFiles) {
  write_mesh(folder / "in.vtp", mesh);
  write_rows("three.csv", "", mesh.vertex_count(), 3);
  write_rows("five.csv", "", mesh.vertex_count(), 5);
  write_rows("named.csv", "velocity_x,velocity_y,velocity_z,frequency,age\n", mesh.vertex_count(),
             5);
  write_rows("tensors.csv", "s_xx,s_yy,s_zz,s_xy,s_yz,s_xz\n", mesh.vertex_count(), 6);
  expect_agreement("in.vtp", {"--field", "three.csv", "--rotate", "20"}, {});
  expect_agreement("in.vtp", {"--field", "five.csv"}, {});
  expect_agreement("in.vtp", {"--field", "named.csv:velocity"}, {});
  expect_agreement("in.vtp", {"--field", "tensors.csv:s", "--tensor", "max-abs"}, {});
}

/// Those that ranks make, whose rows no file has, and of vertices that are split.
TEST_F(MpiToolFields, TakesRowsOfVerticesThatNoFileHas) {
  const Mesh torus = subdivide(make_shape("torus,resolution=12"), 1);
  write_rows("rows.csv", "", torus.vertex_count(), 4);
  expect_agreement("shape:torus,resolution=12", {"--field", "rows.csv", "--subdivide", "1"}, {});
}

TEST_F(MpiToolFields, LetsFrequenciesFollowValues) {
  write_mesh_with_arrays();
  write_rows("values.csv", "a,b,c,d\n", mesh.vertex_count(), 4);
  const Words direction = {"--direction", "0.3,0.9,0.2", "--stripes", "12", "--frequency-by"};
  for (const std::string up : {"x", "-y"}) {
    Words words = direction;
    words.insert(words.end(), {"height", "--up", up});
    expect_agreement("in.vtp", words, {});
  }
  for (const std::string value : {"array:density", "array:cells/flow", "values.csv:d",
                                  "distance:1,0.5,0.25", "height", "curvature"}) {
    Words words = direction;
    words.push_back(value == "height" ? "height@0.5..2,inverse" : value);
    expect_agreement("in.vtp", words, {});
  }
}

/// All go along; cells give directions and frequencies, also where triangles are split.
TEST_F(MpiToolFields, KeepsAndTakesArraysOfTheInput) {
  write_mesh_with_arrays();
  const std::vector<std::string> all = {"density", "label"};
  expect_agreement("in.vtp", {"--field", "array:flow", "--frequency", "array:load"}, all);
  expect_agreement("in.vtp", {"--field", "array:flow", "--frequency", "array:density"}, all);
  expect_agreement("in.vtp",
                   {"--field", "array:flow", "--frequency", "array:cells/load", "--subdivide", "1"},
                   all);
  // Its signs are those of neighbours within a rank.
  run_ranks(1, "in.vtp", {"--field", "array:stress"});
  expect_same_rows(run_alone("in.vtp", {"--field", "array:stress"}), 1, {"direction", "phase"});
  run_ranks(4, "in.vtp", {"--field", "array:stress"});
  for (const char* key : {"vertices_without_wave", "field_rows_nonfinite"}) {
    EXPECT_EQ(report("mpi.json")[key], report("tool.json")[key]) << key;
  }
}

/// Rank 0 sees the whole.
TEST_F(MpiToolFields, SeesMeasuredFieldsAtTheScaleOfTheirStripes) {
  write_mesh_with_arrays();
  write_rows("weights.csv", "a,b,c,d\n", mesh.vertex_count(), 4);
  write_rows("named.csv", "velocity_x,velocity_y,velocity_z,frequency\n", mesh.vertex_count(), 4);
  write_rows("wind.csv", "east,north,up\n", mesh.vertex_count(), 3);
  const Words of_cells = {"--field", "array:flow", "--stripes", "8", "--field-smoothing", "1"};
  const auto with = [](Words words, const std::string& parts, const Words& more = {}) {
    words.back() += parts;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const std::vector<std::string> seen = {"coherence"};
  expect_agreement("in.vtp", of_cells, seen);
  expect_agreement("in.vtp", with(of_cells, ",weight=array:load", {"--along"}), seen);
  expect_agreement("in.vtp", with(of_cells, ",weight=weights.csv:d,fill=1"), seen);
  expect_agreement("in.vtp", with(of_cells, ",singularities=6,arrows"), seen);
  expect_agreement("in.vtp", with(of_cells, "", {"--frequency-by", "array:density"}), seen);
  expect_agreement("in.vtp",
                   {"--field", "array:stress", "--frequency", "array:density", "--field-smoothing",
                    "0.5", "--frequency-smoothing", "0.5"},
                   seen);
  expect_agreement("in.vtp", {"--field", "named.csv:velocity", "--field-smoothing", "2"}, seen);
  expect_agreement("in.vtp", {"--field", "named.csv:velocity", "--frequency-smoothing", "1"}, {});
  expect_agreement("in.vtp", {"--field", "wind.csv", "--stripes", "8", "--field-smoothing", "1"},
                   seen);
  const auto mpi = report("mpi.json");
  EXPECT_GT(mpi["field_turned_median_deg"], 10);
}

/// Of a finer mesh with arrays of its own, from which some vertices are too far.
TEST_F(MpiToolFields, TakesArraysOfAnotherMesh) {
  write_mesh_with_arrays();
  const Words options = {"--field",       "array:flow",   "--frequency-by",
                         "array:density", "--field-mesh", "in.vtp,within=0.3%"};
  expect_agreement("shape:sphere,resolution=12", options, {});
  const auto mpi = report("mpi.json");
  EXPECT_GT(mpi["vertices_without_wave"], 0);
  EXPECT_LT(mpi["vertices_without_wave"], mpi["vertices"]);
}

/// Pieces have the arrays of the input, and what is made of these has them too.
TEST_F(MpiToolFields, KeepsAndTakesArraysOfPieces) {
  mesh = make_shape("sphere,resolution=10");  // of joined vertices pieces know nothing
  write_mesh_with_arrays();
  write_rows("rows.csv", "", mesh.vertex_count(), 4);
  run_ranks(3, "in.vtp", {"--field", "array:flow"});
  for (const auto& entry : {"mpi.pvtp", "mpi_0.vtp", "mpi_1.vtp", "mpi_2.vtp"}) {
    std::string text = content(folder / entry);
    for (std::size_t at = 0; (at = text.find("Source=\"mpi_", at)) != std::string::npos;) {
      text.replace(at, 12, "Source=\"cut_");
    }
    write_text(folder / ("cut" + std::string(entry).substr(3)), text);
  }
  for (const Words& options : {Words{"--field", "rows.csv"},
                               Words{"--direction", "1,2,3", "--frequency", "array:density"}}) {
    const LoadedMesh whole = run_alone("in.vtp", options);
    for (const int ranks : {1, 3}) {
      run_ranks(ranks, "cut.pvtp", options);
      expect_same_rows(whole, ranks, {"frequency", "density", "label"});
      std::size_t cells = 0;
      for (int r = 0; r < ranks; ++r) {
        cells += array_of(piece("mpi_" + std::to_string(r) + ".vtp").arrays.cells, "load").rows();
      }
      EXPECT_EQ(cells, whole.mesh.triangle_count());
    }
  }
  run_ranks(5, "cut.pvtp", {"--field", "array:flow"});  // of ranks without a piece
  // Of cells the order of sums is that of the pieces, for any number of ranks.
  run_ranks(1, "cut.pvtp", {"--field", "array:flow", "--frequency-by", "array:load"});
  LoadedMesh one = piece("mpi_0.vtp");
  const DataArray ids = array_of(one.arrays.points, "global_id");
  std::vector<Index> row_of(ids.rows());
  for (Index v = 0; v < ids.rows(); ++v) row_of[test::value<std::uint64_t>(ids, v)] = v;
  one.arrays.points = rows_of(one.arrays.points, row_of);
  run_ranks(3, "cut.pvtp", {"--field", "array:flow", "--frequency-by", "array:load"});
  expect_same_rows(one, 3, {"direction", "frequency"});
}

/// Rank 0 averages normals of surfaces that it plans.
TEST_F(MpiToolFields, BendsWithAveragedNormals) {
  const Words options = {"--field", "smooth", "--normal-radius", "2%", "--stripes", "15"};
  expect_agreement("shape:vessels,resolution=30", options, {});
}

/// Of several ranks the field is another smooth one that follows the same strokes.
TEST_F(MpiToolFields, FollowsStrokes) {
  write_text(folder / "strokes.json",
             R"({"strokes": [{"radius": 0.3, "strength": 1000, "points": [[1, 0, 0], [0.6, 0, 0.8],
                 [0, 0, 1]]}, {"radius": 0.1, "points": [[0, -1, 0], [0.1, -1, 0.1]]}]})");
  const Words options = {"--strokes", "strokes.json", "--stripes", "15"};
  const LoadedMesh whole = run_alone("shape:sphere,resolution=12", options);
  const std::vector<Vec3>& places = whole.mesh.positions;
  const DataArray& expected = array_of(whole.arrays.points, "direction");
  for (const int ranks : {1, 3}) {
    run_ranks(ranks, "shape:sphere,resolution=12", options);
    if (ranks == 1) expect_same_rows(whole, 1, {"direction", "phase"});
    std::size_t near = 0;
    for (int r = 0; r < ranks; ++r) {
      const LoadedMesh part = piece("mpi_" + std::to_string(r) + ".vtp");
      const DataArray& ids = array_of(part.arrays.points, "global_id");
      const DataArray& directions = array_of(part.arrays.points, "direction");
      for (std::size_t v = 0; v < ids.rows(); ++v) {
        const auto id = test::value<std::uint64_t>(ids, v);
        if (std::abs(places[id].y()) > 0.1f || places[id].x() < 0.3f || places[id].z() < 0.3f) {
          continue;
        }
        Vec3 one, other;
        std::memcpy(one.data(), &directions.bytes[12 * v], 12);
        std::memcpy(other.data(), &expected.bytes[12 * id], 12);
        EXPECT_GT(std::abs(one.dot(other)), 0.999f);
        ++near;
      }
    }
    EXPECT_GT(near, 3u);
  }
}

TEST_F(MpiToolFields, RefusesFilesThatDoNotFit) {
  write_mesh_with_arrays();
  write_rows("short.csv", "", 7, 3);
  write_text(folder / "words.csv", "1,2,3\n4,five,6\n");
  const auto refuses = [&](const Words& options, int code, const std::string& message) {
    Words words = {"in.vtp", "--output", "out.pvtp", "--report", "out.json"};
    words.insert(words.end(), options.begin(), options.end());
    expect_failure(on(2, words), code, message);
    EXPECT_FALSE(std::filesystem::exists(folder / "out.json"));
  };
  write_text(folder / "far.json",
             R"({"strokes": [{"radius": 0.1, "points": [[1, 0, 0], [3, 0, 0]]}]})");
  refuses({"--strokes", "far.json"}, 1, "strokes[0]: point 1 is 2.0");
  refuses({"--strokes", "words.csv"}, 1, "words.csv");
  refuses({"--field", "short.csv"}, 1, "short.csv");
  refuses({"--field", "words.csv"}, 1, "five");
  refuses({"--field", "nothing.csv"}, 1, "nothing.csv");
  refuses({"--field", "short.csv", "--tensor", "major"}, 2, "--tensor");
  refuses({"--direction", "1,0,0", "--frequency-by", "short.csv"}, 1, "short.csv");
  refuses({"--direction", "1,0,0", "--frequency-by", "array:loads"}, 1, "did you mean 'load'");
  refuses({"--direction", "1,0,0", "--frequency-by", "light"}, 2, "camera");
  refuses({"--field", "array:flow", "--field-mesh", "words.csv"}, 1, "words.csv");
}

/// Rows of a file mean nothing where vertices are told by their places.
TEST_F(MpiToolFields, RefusesRowsForPiecesWithoutNumbers) {
  write_mesh(folder / "part.vtp", mesh);
  write_text(folder / "in.pvtp",
             "<VTKFile type=\"PPolyData\"><PPolyData><Piece Source=\"part.vtp\"/></PPolyData>"
             "</VTKFile>");
  write_rows("rows.csv", "", mesh.vertex_count(), 4);
  for (const Words& options :
       {Words{"--field", "rows.csv"}, Words{"--direction", "1,0,0", "--frequency-by", "rows.csv:c"},
        Words{"--slack", "0.2", "--avoid-branches", "rows.csv"}}) {
    Words words = {"in.pvtp", "--output", "out.pvtp"};
    words.insert(words.end(), options.begin(), options.end());
    const auto result = on(2, words);
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find("no global ids"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out.pvtp"));
  }
}

}  // namespace
}  // namespace brindle
