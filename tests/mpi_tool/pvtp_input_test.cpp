#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "brindle/shapes.h"
#include "mpi_tool/mpi_tool.h"

namespace brindle {
namespace {

using test::array_of;
using test::content;
using test::MpiTool;
using test::value;
using test::write_text;

struct MpiToolPvtp : MpiTool {
  nlohmann::json report(const std::string& name) const {
    return nlohmann::json::parse(content(folder / name));
  }

  void write_pieces_of(const std::string& mesh, int ranks) const {
    const auto result = on(ranks, {mesh, "--direction", "0.3,0.9,0.2", "--stripes", "20",
                                   "--output", "in.pvtp", "--report", "in.json", "--quiet"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }

  void expect_refused(const std::string& message) const {
    for (const auto& name : listing()) {
      if (name.starts_with("out")) std::filesystem::remove(folder / name);
    }
    const auto result = on(2, {"in.pvtp", "--output", "out.pvtp", "--report", "out.json"});
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    const std::size_t first = result.err.find("brindle: ");
    EXPECT_EQ(result.err.find("brindle: ", first + 1), std::string::npos) << result.err;
    for (const auto& name : listing()) EXPECT_FALSE(name.starts_with("out")) << name;
  }
};

/// Pieces lie on the same ranks as before: so their phases have the same bits.
TEST_F(MpiToolPvtp, ReadsThePiecesThatItWrites) {
  write_pieces_of("shape:sheets,resolution=30", 3);
  for (const int ranks : {1, 2, 5}) {
    const auto result = on(ranks, {"in.pvtp", "--direction", "0.3,0.9,0.2", "--stripes", "20",
                                   "--output", "out.pvtp", "--report", "out.json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err.find("2 of them have none") != std::string::npos, ranks == 5);
    for (const char* key : {"vertices", "triangles", "edges"}) {
      EXPECT_EQ(report("out.json")[key], report("in.json")[key]) << key << " on " << ranks;
    }
    if (ranks != 3) continue;
    for (const char* piece : {"_0.vtp", "_1.vtp", "_2.vtp"}) {
      const LoadedMesh before = this->piece("in" + std::string(piece));
      const LoadedMesh after = this->piece("out" + std::string(piece));
      EXPECT_EQ(before.mesh.positions, after.mesh.positions);
      EXPECT_EQ(before.mesh.triangles, after.mesh.triangles);
      for (const char* name : {"global_id", "phase"}) {
        EXPECT_EQ(array_of(before.arrays.points, name).bytes,
                  array_of(after.arrays.points, name).bytes)
            << name;
      }
    }
  }
}

TEST_F(MpiToolPvtp, SubdividesPiecesAsTheWhole) {
  write_pieces_of("shape:mobius,resolution=8", 3);
  ASSERT_EQ(on(2, {"in.pvtp", "--subdivide", "2", "--report", "out.json"}).exit_code, 0);
  ASSERT_EQ(
      on(2, {"shape:mobius,resolution=8", "--subdivide", "2", "--report", "whole.json"}).exit_code,
      0);
  for (const char* key : {"vertices", "triangles", "edges"}) {
    EXPECT_EQ(report("out.json")[key], report("whole.json")[key]) << key;
  }
}

/// Rows `first` to `last` of a lattice of 9 columns, as VTK writes a piece: with one more row of
/// ghosts at either end, and numbers of points.
struct LatticePiece {
  int first, last;
  bool ids = true;
  double offset = 0;  ///< of all coordinates
  std::string id_name = "GlobalPointIds";
  int id_shift = 0;
  int id_factor = 1;  ///< of numbers before they are taken modulo 1009
  bool flags = true;  ///< whether ghosts are said to be some
};

constexpr int kColumns = 9, kRows = 13;

std::string piece_text(const LatticePiece& piece) {
  const int begin = std::max(0, piece.first - 1), end = std::min(kRows - 1, piece.last + 1);
  std::ostringstream points, ids, cells, ends, ghosts;
  points.precision(17);
  int triangles = 0;
  for (int row = begin; row <= end; ++row) {
    for (int i = 0; i < kColumns; ++i) {
      points << piece.offset + 0.1 * i << ' ' << piece.offset + 0.1 * row << ' '
             << piece.offset + 0.01 * i * row << '\n';
      ids << (row * kColumns + i) * piece.id_factor % 1009 + piece.id_shift << ' ';
      if (row == end || i + 1 == kColumns) continue;
      const int a = (row - begin) * kColumns + i;
      for (const Triangle& t : {Triangle{0, 1, kColumns}, Triangle{1, kColumns + 1, kColumns}}) {
        for (const Index corner : t) cells << a + static_cast<int>(corner) << ' ';
        ends << 3 * ++triangles << ' ';
        ghosts << (piece.flags && (row < piece.first || row >= piece.last) ? 1 : 0) << ' ';
      }
    }
  }
  const auto array = [](const std::string& type, const std::string& name, int components,
                        const std::string& numbers) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\" format=\"ascii\">" + numbers + "</DataArray>\n";
  };
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
         "<Piece NumberOfPoints=\"" +
         std::to_string((end - begin + 1) * kColumns) + "\" NumberOfPolys=\"" +
         std::to_string(triangles) + "\">\n<PointData GlobalIds=\"" + piece.id_name + "\">\n" +
         (piece.ids ? array("Int64", piece.id_name, 1, ids.str()) : "") +
         "</PointData>\n<CellData>\n" + array("UInt8", "vtkGhostType", 1, ghosts.str()) +
         "</CellData>\n<Points>\n" + array("Float64", "Points", 3, points.str()) +
         "</Points>\n<Polys>\n" + array("Int64", "connectivity", 1, cells.str()) +
         array("Int64", "offsets", 1, ends.str()) + "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

/// A piece without points is none that VTK minds.
constexpr const char* kEmptyPiece =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece "
    "NumberOfPoints=\"0\" NumberOfPolys=\"0\"></Piece></PolyData></VTKFile>\n";

std::string pvtp_text(const std::vector<std::string>& pieces, const std::string& arrays = "") {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PPolyData\" version=\"0.1\">\n"
      "<PPolyData GhostLevel=\"1\">\n" +
      arrays;
  for (const std::string& piece : pieces) text += "<Piece Source=\"" + piece + "\"/>\n";
  return text + "</PPolyData>\n</VTKFile>\n";
}

struct MpiToolLattice : MpiToolPvtp {
  /// Three pieces and an empty one.
  void write_lattice(const std::function<void(LatticePiece&)>& change = {}) const {
    std::filesystem::create_directories(folder / "in");
    const std::pair<int, int> rows[] = {{0, 4}, {4, 9}, {9, kRows - 1}};
    std::vector<std::string> names;
    for (const auto& [first, last] : rows) {
      LatticePiece piece{.first = first, .last = last};
      if (change) change(piece);
      names.push_back("in/in_" + std::to_string(names.size()) + ".vtp");
      write_text(folder / names.back(), piece_text(piece));
    }
    names.push_back("in/empty.vtp");
    write_text(folder / names.back(), kEmptyPiece);
    write_text(folder / "in.pvtp", pvtp_text(names));
  }

  void expect_whole_lattice() const {
    for (const int ranks : {1, 3}) {
      const auto result = on(ranks, {"in.pvtp", "--stripes", "3", "--report", "out.json"});
      ASSERT_EQ(result.exit_code, 0) << result.err;
      EXPECT_NE(result.err.find("ghost triangles"), std::string::npos) << result.err;
      EXPECT_EQ(report("out.json")["vertices"], kColumns * kRows);
      EXPECT_EQ(report("out.json")["triangles"], 2 * (kColumns - 1) * (kRows - 1));
      EXPECT_EQ(report("out.json")["edges"],
                kRows * (kColumns - 1) + kColumns * (kRows - 1) + (kRows - 1) * (kColumns - 1));
    }
  }
};

TEST_F(MpiToolLattice, OfVtkWithGhostsIsTheWholeOnce) {
  write_lattice();
  expect_whole_lattice();
  write_lattice([](LatticePiece& piece) { piece.id_name = "numbers_of_mine"; });
  std::string text = content(folder / "in.pvtp");
  text.insert(text.find("<Piece"), "<PPointData GlobalIds=\"numbers_of_mine\"></PPointData>\n");
  write_text(folder / "in.pvtp", text);
  expect_whole_lattice();
}

TEST_F(MpiToolLattice, WithoutIdsJoinsWhatStandsAtOnePlace) {
  for (const double offset : {0.0, 123456.7}) {
    write_lattice([&](LatticePiece& piece) { piece.ids = false, piece.offset = offset; });
    expect_whole_lattice();
  }
  const auto result = on(2, {"in.pvtp", "--stripes", "3"});
  EXPECT_NE(result.err.find("exactly the same place"), std::string::npos) << result.err;
}

TEST_F(MpiToolLattice, RefusesNumbersThatAreNotThoseOfTheWhole) {
  write_lattice([](LatticePiece& piece) { piece.id_shift = piece.first > 4 ? -20 : 0; });
  expect_refused("stands elsewhere than that of ");
  write_lattice([](LatticePiece& piece) { piece.id_shift = -1; });
  expect_refused("has -1 for point 0");
  write_lattice([](LatticePiece& piece) { piece.ids = piece.first != 4; });
  expect_refused("in_1.vtp: has no global ids");
}

TEST_F(MpiToolLattice, RefusesPiecesThatCannotBeRead) {
  write_lattice();
  std::filesystem::remove(folder / "in" / "in_2.vtp");
  expect_refused("in_2.vtp");
  write_lattice();
  const std::string whole = content(folder / "in" / "in_2.vtp");
  write_text(folder / "in" / "in_2.vtp", whole.substr(0, whole.size() / 2));
  expect_refused("in_2.vtp");
  write_lattice();
  write_text(folder / "in.pvtp",
             pvtp_text({"in/in_0.vtp", "in/in_1.vtp"},
                       "<PCellData><PDataArray type=\"Float32\" Name=\"load\"/></PCellData>\n"));
  expect_refused("array 'load' of cells is missing");
  write_text(folder / "in.pvtp", pvtp_text({"in/empty.vtp"}));
  expect_refused("no usable triangle");
}

TEST_F(MpiToolLattice, RefusesWhatIsNoListOfPieces) {
  expect_refused("in.pvtp: there is no such file");
  write_text(folder / "in.pvtp", "ply\nformat ascii 1.0\n");
  expect_refused("in.pvtp: is no XML");
  write_text(folder / "in.pvtp", pvtp_text({}));
  expect_refused("in.pvtp: names no piece");
  write_text(folder / "in.pvtp", pvtp_text({""}));
  expect_refused("in.pvtp: has a Piece without its 'Source'");
  write_text(folder / "in.pvtp",
             "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid/></VTKFile>\n");
  expect_refused("PUnstructuredGrid");
}

TEST_F(MpiToolPvtp, DoesNotOverwriteItsPieces) {
  write_pieces_of("shape:torus,resolution=30", 2);
  const std::string before = content(folder / "in_1.vtp");
  std::string list = content(folder / "in.pvtp");
  write_text(folder / "other.pvtp", list);
  const auto result = on(2, {"other.pvtp", "--output", "in.pvtp"});
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_EQ(content(folder / "in_1.vtp"), before);
}

/// A sphere with vectors round the z axis, a tensor with that axis, and a frequency, in one file.
void write_arrays(const std::filesystem::path& path) {
  const Mesh mesh = make_shape("sphere,resolution=14");
  std::vector<Vec3> vectors;
  std::vector<double> tensors;
  std::vector<float> frequencies;
  for (const Vec3& p : mesh.positions) {
    const Vec3 round(-p.y(), p.x(), 0);
    vectors.push_back(3 * round);
    const Eigen::Matrix3d tensor = (round * round.transpose()).cast<double>();
    for (const auto& [row, column] : {std::pair(0, 0), std::pair(1, 1), std::pair(2, 2),
                                      std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)}) {
      tensors.push_back(tensor(row, column));
    }
    frequencies.push_back(p.z() > 0.97f ? NAN : 6 + 2 * p.z());
  }
  const std::vector<DataArray> arrays = {make_data_array("round", vectors),
                                         make_data_array("stress", 6, tensors),
                                         make_data_array("density", 1, frequencies)};
  write_mesh(path, mesh, arrays);
}

/// What 'brindle' and one rank make of a file's arrays is the same; several ranks have the same
/// directions and frequencies, and so have pieces.
TEST_F(MpiToolPvtp, TakesWavesFromArraysOfPoints) {
  write_arrays(folder / "arrays.vtp");
  write_text(folder / "arrays.pvtp",
             "<VTKFile type=\"PPolyData\"><PPolyData><Piece Source=\"arrays.vtp\"/></PPolyData>"
             "</VTKFile>");
  for (const std::string field : {"array:round", "array:points/stress"}) {
    const test::Words options = {"--field",  field,     "--frequency", "array:density", "--output",
                                 "out.pvtp", "--quiet", "--report",    "out.json"};
    test::Words tool = {"1000", BRINDLE_TOOL_ALONE, "stripe", "arrays.vtp"};
    tool.insert(tool.end(), options.begin(), options.end());
    tool[9] = "tool.vtp";
    tool.back() = "tool.json";
    ASSERT_EQ(test::run_tool(tool, folder).exit_code, 0);
    const LoadedMesh expected = piece("tool.vtp");
    for (const char* file : {"arrays.vtp", "arrays.pvtp"}) {
      test::Words mine = {file};
      mine.insert(mine.end(), options.begin(), options.end());
      ASSERT_EQ(on(1, mine).exit_code, 0);
      const LoadedMesh one = piece("out_0.vtp");
      for (const char* name : {"phase", "direction", "frequency"}) {
        EXPECT_EQ(array_of(one.arrays.points, name).bytes,
                  array_of(expected.arrays.points, name).bytes)
            << name << " of " << file;
      }
      const auto result = on(3, mine);
      ASSERT_EQ(result.exit_code, 0) << result.err;
      for (const char* key :
           {"vertices", "vertices_without_wave", "frequency_min", "frequency_max"}) {
        EXPECT_EQ(report("out.json")[key], report("tool.json")[key]) << key;
      }
    }
  }
}

TEST_F(MpiToolPvtp, RefusesArraysThatItCannotTake) {
  write_arrays(folder / "arrays.vtp");
  expect_failure(on(2, {"arrays.vtp", "--field", "array:rounds"}), 1, "did you mean 'round'");
  expect_failure(on(2, {"arrays.vtp", "--field", "array:density"}), 1, "density");
  expect_failure(on(2, {"arrays.vtp", "--field", "array:round", "--tensor", "major"}), 2,
                 "--tensor");
  expect_failure(on(2, {"arrays.vtp", "--field", "array:cells/round"}), 1, "no array");
  expect_failure(on(2, {"shape:torus", "--field", "array:round"}), 1, "no array 'round'");
}

/// Four pieces of the lattice that share rows of triangles, whether or not they say so. Numbers go
/// criss-cross.
TEST_F(MpiToolPvtp, HasOnePatternOnAnyNumberOfRanks) {
  for (const bool ids : {true, false}) {
    for (const bool flags : {true, false}) {
      SCOPED_TRACE(std::string(ids ? "ids" : "no ids") + (flags ? ", flags" : ", no flags"));
      std::vector<std::string> names;
      for (int p = 0; p < 4; ++p) {
        names.push_back("in_" + std::to_string(p) + ".vtp");
        write_text(folder / names.back(),
                   piece_text({3 * p, 3 * p + 3, ids, 0, "GlobalPointIds", 0, 37, flags}));
      }
      write_text(folder / "in.pvtp", pvtp_text(names));
      nlohmann::json one;
      std::map<std::array<float, 3>, float> phases;
      for (int ranks = 1; ranks <= 4; ++ranks) {
        const auto result = on(
            ranks, {"in.pvtp", "--stripes", "8", "--report", "out.json", "--output", "out.pvtp"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err.find("stand twice") == std::string::npos, flags) << result.err;
        const auto json = report("out.json");
        EXPECT_EQ(json["vertices"], kColumns * kRows);
        EXPECT_EQ(json["triangles"], 2 * (kColumns - 1) * (kRows - 1));
        if (ranks == 1) one = json;
        EXPECT_EQ(json["branches"], one["branches"]) << ranks;
        EXPECT_NEAR(json["energy"].get<double>(), one["energy"].get<double>(), 1e-9) << ranks;
        std::size_t triangles = 0;
        for (int r = 0; r < ranks; ++r) {
          const LoadedMesh piece = this->piece("out_" + std::to_string(r) + ".vtp");
          triangles += piece.mesh.triangle_count();
          for (std::size_t v = 0; v < piece.mesh.vertex_count(); ++v) {
            const Vec3& p = piece.mesh.positions[v];
            const float phase = value<float>(array_of(piece.arrays.points, "phase"), v);
            const auto known = phases.emplace(std::array{p.x(), p.y(), p.z()}, phase).first;
            EXPECT_EQ(known->second, phase) << ranks << " ranks";
          }
        }
        EXPECT_EQ(triangles, 2u * (kColumns - 1) * (kRows - 1));
      }
    }
  }
}

TEST_F(MpiToolPvtp, SaysWhatOnePieceHasAlone) {
  write_pieces_of("shape:torus,resolution=20", 2);
  std::string list = content(folder / "in.pvtp");
  const std::size_t at = list.find("<PDataArray type=\"Float32\" Name=\"sin_phase\"");
  ASSERT_NE(at, std::string::npos);
  list.erase(at, list.find("/>", at) + 2 - at);
  write_text(folder / "in.pvtp", list);
  for (const int ranks : {1, 3}) {
    const auto result = on(ranks, {"in.pvtp", "--output", "out.pvtp"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.err.find("'sin_phase' is not announced"), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace brindle
