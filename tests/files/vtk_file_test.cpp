#include "brindle/files/vtk_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "vtk_texts.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

using Numbers = std::vector<std::int64_t>;

const std::vector<float> kPlaces = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1,   1,
                                    0, 2, 1, 0, 0, 2, 0, 1, 2, 0, 2, 2, 0.5f};

/// Cells of one kind.
struct Cells {
  Numbers points, ends;
};

/// All kinds that PolyData has: nine points and nine cells, of which four are surface.
const Cells kVerts = {{0, 1, 2}, {1, 3}};
const Cells kLines = {{0, 1, 2, 3, 4, 1, 5}, {3, 5, 7}};
const Cells kPolys = {{0, 1, 4, 3, 4, 5, 8}, {4, 7}};
const Cells kStrips = {{3, 4, 6, 7, 1, 2, 4}, {4, 7}};

const std::vector<Triangle> kTriangles = {{0, 1, 4}, {0, 4, 3}, {4, 5, 8},
                                          {3, 4, 6}, {6, 4, 7}, {1, 2, 4}};
const std::vector<Index> kCellOfTriangle = {5, 5, 6, 7, 7, 8};

DataArray places() { return make_data_array("Points", 3, kPlaces); }

std::string cells_xml(VtkXmlText& text, const std::string& element, const Cells& cells) {
  return text.arrays(element, {make_data_array("connectivity", 1, cells.points),
                               make_data_array("offsets", 1, cells.ends)});
}

/// Several times the same piece.
std::string poly_data(const VtkXmlStyle& style, const DataArrays& arrays, int pieces = 1) {
  VtkXmlText text(style);
  std::string body;
  for (int piece = 0; piece < pieces; ++piece) {
    body +=
        "<Piece NumberOfPoints=\"9\" NumberOfVerts=\"2\" NumberOfLines=\"3\" NumberOfStrips=\"2\" "
        "NumberOfPolys=\"2\">\n";
    body += text.arrays("PointData", arrays.points) + text.arrays("CellData", arrays.cells) +
            text.arrays("Points", {places()});
    body += cells_xml(text, "Verts", kVerts) + cells_xml(text, "Lines", kLines) +
            cells_xml(text, "Strips", kStrips) + cells_xml(text, "Polys", kPolys) + "</Piece>\n";
  }
  return text.file("PolyData", body);
}

std::string grid(const VtkXmlStyle& style, const Cells& cells,
                 const std::vector<std::uint8_t>& types, const DataArrays& arrays = {}) {
  VtkXmlText text(style);
  std::string body = "<Piece NumberOfPoints=\"9\" NumberOfCells=\"" + std::to_string(types.size()) +
                     "\">\n" + text.arrays("PointData", arrays.points) +
                     text.arrays("CellData", arrays.cells) + text.arrays("Points", {places()}) +
                     text.arrays("Cells", {make_data_array("connectivity", 1, cells.points),
                                           make_data_array("offsets", 1, cells.ends),
                                           make_data_array("types", 1, types)}) +
                     "</Piece>\n";
  return text.file("UnstructuredGrid", body);
}

DataArrays every_type(bool nan = true) {
  return {arrays_of_every_type(9, nan), arrays_of_every_type(9, nan)};
}

/// A legacy file of the same, of version 4 or 5.
class LegacyText {
 public:
  LegacyText(bool binary, int version) : binary_(binary), version_(version) {
    text_ = "# vtk DataFile Version " + std::to_string(version) + ".1\nof a test\n" +
            (binary ? "BINARY" : "ASCII") + '\n';
  }

  LegacyText& line(const std::string& text) {
    text_ += text + '\n';
    return *this;
  }
  LegacyText& numbers(const DataArray& array) {
    text_ += (binary_ ? raw_numbers(array, true) : numbers_as_text(array)) + '\n';
    return *this;
  }
  LegacyText& points() { return line("POINTS 9 float").numbers(places()); }
  LegacyText& cells(const std::string& keyword, const Cells& cells) {
    Numbers starts = {0};
    starts.insert(starts.end(), cells.ends.begin(), cells.ends.end());
    if (version_ >= 5) {
      line(keyword + ' ' + std::to_string(starts.size()) + ' ' +
           std::to_string(cells.points.size()));
      line("OFFSETS vtktypeint64").numbers(make_data_array("", 1, starts));
      return line("CONNECTIVITY vtktypeint64").numbers(make_data_array("", 1, cells.points));
    }
    std::vector<std::int32_t> row;
    for (std::size_t c = 0; c + 1 < starts.size(); ++c) {
      row.push_back(static_cast<std::int32_t>(starts[c + 1] - starts[c]));
      for (auto p = starts[c]; p < starts[c + 1]; ++p) {
        row.push_back(static_cast<std::int32_t>(cells.points[p]));
      }
    }
    line(keyword + ' ' + std::to_string(cells.ends.size()) + ' ' + std::to_string(row.size()));
    return numbers(make_data_array("", 1, row));
  }
  LegacyText& field(const std::vector<DataArray>& arrays) {
    line("FIELD FieldData " + std::to_string(arrays.size()));
    for (const DataArray& array : arrays) {
      std::string name = array.name;
      for (std::size_t at; (at = name.find(' ')) != std::string::npos;) name.replace(at, 1, "%20");
      line(name + ' ' + std::to_string(array.components) + ' ' + std::to_string(array.rows()) +
           ' ' + type_name(array.type))
          .numbers(array);
      if (version_ >= 5) line("METADATA\nINFORMATION 0\n");
    }
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  static std::string type_name(NumberType type) {
    return std::vector<std::string>{"float",        "double",         "char", "unsigned_char",
                                    "short",        "unsigned_short", "int",  "unsigned_int",
                                    "vtktypeint64", "vtktypeuint64"}[static_cast<std::size_t>(
        type)];
  }
  std::string text_;
  bool binary_;
  int version_;
};

std::string legacy(bool binary, int version, const DataArrays& arrays) {
  LegacyText text(binary, version);
  text.line("DATASET POLYDATA").points();
  text.cells("VERTICES", kVerts).cells("TRIANGLE_STRIPS", kStrips).cells("LINES", kLines);
  text.cells("POLYGONS", kPolys).line("CELL_DATA 9").field(arrays.cells);
  return text.line("POINT_DATA 9").field(arrays.points).text();
}

struct VtkFile : testing::Test {
  fs::path folder =
      fs::path(testing::TempDir()) /
      (std::string("vtk_file_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  fs::path save(const std::string& name, const std::string& content) const {
    std::ofstream(folder / name, std::ios::binary) << content;
    return folder / name;
  }
  LoadedMesh read(const std::string& name, const std::string& content) const {
    return read_mesh(save(name, content));
  }
  std::string error_of(const std::string& name, const std::string& content) const {
    try {
      read(name, content);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  /// That the file holds all kinds of PolyData with these arrays.
  void expect_all(const LoadedMesh& loaded, const DataArrays& arrays, const std::string& what) {
    EXPECT_EQ(loaded.mesh.triangles, kTriangles) << what;
    ASSERT_EQ(loaded.mesh.vertex_count(), 9u) << what;
    EXPECT_EQ(loaded.mesh.positions[8], Vec3(2, 2, 0.5f)) << what;
    EXPECT_EQ(loaded.arrays.points, arrays.points) << what;
    EXPECT_EQ(loaded.arrays.cells, rows_of(arrays.cells, kCellOfTriangle)) << what;
    EXPECT_NE(loaded.left_out.find("5 cells that are points or lines: left out"), std::string::npos)
        << what;
  }
};

#define EXPECT_TELLS(message, part) \
  EXPECT_NE((message).find(part), std::string::npos) << "message: '" << (message) << "'"

#ifdef BRINDLE_HAS_VTK

std::string name_of_style(const VtkXmlStyle& style) {
  return style.format + (style.zlib ? ", zlib" : "") + (style.wide ? ", UInt64" : "") +
         (style.big_endian ? ", big endian" : "");
}

TEST_F(VtkFile, ReadsPolyDataWithArraysOfEveryTypeInEveryEncoding) {
  const DataArrays arrays = every_type();
  for (const VtkXmlStyle& style : vtk_xml_styles()) {
    expect_all(read("a.vtp", poly_data(style, arrays)), arrays, name_of_style(style));
  }
}

TEST_F(VtkFile, PiecesFollowEachOther) {
  const DataArrays arrays = every_type();
  for (const VtkXmlStyle& style : vtk_xml_styles()) {
    const LoadedMesh loaded = read("a.vtp", poly_data(style, arrays, 2));
    // The second piece lies on the first: its points are joined with those, its triangles dropped.
    EXPECT_EQ(loaded.mesh.triangles, kTriangles) << name_of_style(style);
    EXPECT_EQ(loaded.repair.triangles_duplicate, kTriangles.size());
    EXPECT_EQ(loaded.repair.vertices_joined, 9u);
    std::vector<Index> twice;
    for (Index i = 0; i < 18; ++i) twice.push_back(i % 9);
    EXPECT_EQ(loaded.arrays.points, rows_of(arrays.points, twice));
    EXPECT_EQ(loaded.arrays.cells, rows_of(arrays.cells, kCellOfTriangle));
  }
}

TEST_F(VtkFile, ArraysThatAPieceLacksAreLeftOutAndNamed) {
  VtkXmlText text({});
  const std::vector<float> one(3, 1);
  std::string pieces;
  for (const char* name : {"everywhere", "here"}) {
    pieces += "<Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\">" +
              text.arrays("PointData",
                          {make_data_array("everywhere", 1, one), make_data_array(name, 1, one)}) +
              text.arrays("Points",
                          {make_data_array("", 3, std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0})}) +
              cells_xml(text, "Polys", {{0, 1, 2}, {3}}) + "</Piece>";
  }
  pieces += "<Piece NumberOfPoints=\"0\" NumberOfPolys=\"0\"/>";
  const LoadedMesh loaded = read("a.vtp", text.file("PolyData", pieces));
  ASSERT_EQ(loaded.arrays.points.size(), 1u);
  EXPECT_EQ(loaded.arrays.points[0].name, "everywhere");
  EXPECT_EQ(loaded.arrays.points[0].rows(), 6u);
  EXPECT_TELLS(loaded.left_out, "'here'");
  EXPECT_TELLS(loaded.left_out, "'everywhere_2'");
}

TEST_F(VtkFile, ReadsTheSurfaceCellsOfGrids) {
  // A quadrangle, a tetrahedron, a pixel, a quadratic triangle, a line, a triangle.
  const Cells cells = {{0, 1, 4, 3, 0, 1, 3, 8, 1, 2, 4, 5, 0, 2, 6, 1, 4, 3, 0, 1, 4, 5, 8},
                       {4, 8, 12, 18, 20, 23}};
  const std::vector<std::uint8_t> types = {9, 10, 8, 22, 3, 5};
  const DataArrays arrays = {arrays_of_every_type(9), arrays_of_every_type(6)};
  for (const VtkXmlStyle& style : vtk_xml_styles()) {
    const LoadedMesh loaded = read("a.vtu", grid(style, cells, types, arrays));
    const std::vector<Triangle>& t = loaded.mesh.triangles;
    ASSERT_EQ(t.size(), 9u);
    EXPECT_EQ(t[0], (Triangle{0, 1, 4}));
    EXPECT_EQ(t[1], (Triangle{0, 4, 3}));
    // The pixel 1 2 4 5 goes round as 1 2 5 4.
    EXPECT_EQ(t[2], (Triangle{1, 2, 5}));
    EXPECT_EQ(t[3], (Triangle{1, 5, 4}));
    EXPECT_EQ(t[8], (Triangle{4, 5, 8}));
    EXPECT_EQ(loaded.arrays.points, arrays.points);
    EXPECT_EQ(loaded.arrays.cells,
              rows_of(arrays.cells, std::vector<Index>{0, 0, 2, 2, 3, 3, 3, 3, 5}));
    EXPECT_TELLS(loaded.left_out, "1 volume cells");
  }
}

TEST_F(VtkFile, VolumesAloneAreRefusedWithTheRemedy) {
  const std::string file = grid({}, {{0, 1, 3, 8}, {4}}, {10});
  EXPECT_TELLS(error_of("a.vtu", file), "Extract Surface");
  EXPECT_FALSE(is_point_file(folder / "a.vtu"));
  EXPECT_EQ(read_points(folder / "a.vtu").cloud.positions.size(), 9u);
}

TEST_F(VtkFile, FilesWithoutSurfaceAreFilesOfPoints) {
  const DataArrays arrays = {arrays_of_every_type(9), {}};
  VtkXmlText text({"appended raw"});
  const std::string piece = "<Piece NumberOfPoints=\"9\">" +
                            text.arrays("PointData", arrays.points) +
                            text.arrays("Points", {places()}) + "</Piece>";
  const std::string with_normals = std::string("<PointData Normals=\"of float64\">");
  std::string named = piece;
  named.replace(named.find("<PointData>"), 11, with_normals);
  for (const fs::path& path :
       {save("a.vtp", text.file("PolyData", piece)), save("b.vtk", legacy(true, 4, {}))}) {
    EXPECT_EQ(is_point_file(path), path.extension() == ".vtp");
  }
  const LoadedPoints points = read_points(folder / "a.vtp");
  EXPECT_EQ(points.cloud.positions.size(), 9u);
  EXPECT_EQ(points.arrays, arrays.points);
  EXPECT_TRUE(points.cloud.normals.empty());
  save("c.vtu", grid({}, {{0, 1, 2}, {1, 3}}, {1, 3}));
  EXPECT_TRUE(is_point_file(folder / "c.vtu"));
}

TEST_F(VtkFile, NormalsOfPointsAreTheirs) {
  VtkXmlText text({});
  std::vector<float> up(27, 0);
  for (std::size_t i = 2; i < up.size(); i += 3) up[i] = 2;
  std::string piece = "<Piece NumberOfPoints=\"9\">" +
                      text.arrays("PointData", {make_data_array("n", 3, up)}) +
                      text.arrays("Points", {places()}) + "</Piece>";
  piece.replace(piece.find("<PointData>"), 11, "<PointData Normals=\"n\">");
  const LoadedPoints points = read_points(save("a.vtp", text.file("PolyData", piece)));
  EXPECT_EQ(points.cloud.normals, std::vector<Vec3>(9, Vec3(0, 0, 1)));
}

TEST_F(VtkFile, RowsFollowTheirTrianglesThroughRepairs) {
  VtkXmlText text({"binary"});
  // The second polygon has no area, the third stands twice, and point 3 stands where 0 is.
  const std::vector<float> at = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
  const Cells polys = {{0, 1, 2, 0, 1, 4, 3, 2, 1, 3, 1, 5}, {3, 6, 9, 12}};
  const std::string piece =
      "<Piece NumberOfPoints=\"6\" NumberOfPolys=\"4\">" +
      text.arrays("CellData", {make_data_array("row", 1, Numbers{10, 11, 12, 13})}) +
      text.arrays("PointData", {make_data_array("row", 1, Numbers{0, 1, 2, 3, 4, 5})}) +
      text.arrays("Points", {make_data_array("", 3, at)}) + cells_xml(text, "Polys", polys) +
      "</Piece>";
  const LoadedMesh loaded = read("a.vtp", text.file("PolyData", piece));
  EXPECT_EQ(loaded.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 5}}));
  EXPECT_EQ(loaded.arrays.cells[0], make_data_array("row", 1, Numbers{10, 13}));
  EXPECT_EQ(loaded.arrays.points[0], make_data_array("row", 1, Numbers{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(loaded.vertex_of_row, (std::vector<Index>{0, 1, 2, 0, 4, 5}));
}

TEST_F(VtkFile, NamesAreAsInTheFileAndDifferent) {
  VtkXmlText text({});
  const std::vector<float> one(9, 1);
  std::vector<DataArray> arrays;
  for (const char* name : {"Geschwindigkeit &lt;m/s&gt; \xc3\xa4", "", "a", "a", "a_2", ""}) {
    arrays.push_back(make_data_array(name, 1, one));
  }
  const LoadedMesh loaded = read("a.vtp", poly_data({}, {arrays, {}}));
  std::vector<std::string> names;
  for (const DataArray& array : loaded.arrays.points) names.push_back(array.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Geschwindigkeit <m/s> \xc3\xa4", "unnamed", "a",
                                             "a_3", "a_2", "unnamed_2"}));
}

TEST_F(VtkFile, WhatIsNoNumberIsLeftOutAndNamed) {
  std::string file = poly_data({}, every_type());
  file.insert(file.find("<PointData>") + 11,
              "<Array type=\"String\" Name=\"labels\" format=\"ascii\">65 0 </Array>");
  const LoadedMesh loaded = read("a.vtp", file);
  EXPECT_EQ(loaded.arrays.points.size(), 10u);
  EXPECT_TELLS(loaded.left_out, "'labels'");
}

TEST_F(VtkFile, ErrorsNameTheArrayAndTheRemedy) {
  const std::string ascii = poly_data({}, every_type(false));
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  EXPECT_TELLS(error_of("a.vtp", with(ascii, "of int8\" NumberOfComponents=\"2",
                                      "of int8\" "
                                      "NumberOfComponents=\"3")),
               "'of int8' has fewer");
  EXPECT_TELLS(error_of("a.vtp", with(ascii, "of int8\" NumberOfComponents=\"2",
                                      "of int8\" "
                                      "NumberOfComponents=\"1")),
               "'of int8' has more");
  EXPECT_TELLS(error_of("a.vtp", with(ascii, "127", "128")), "'of int8' has '128'");
  EXPECT_TELLS(error_of("a.vtp", with(ascii, "NumberOfPoints=\"9\"", "NumberOfPoints=\"-9\"")),
               "NumberOfPoints");
  EXPECT_TELLS(error_of("a.vtp", with(ascii, "type=\"PolyData\"", "type=\"ImageData\"")),
               "Extract Surface");
  EXPECT_TELLS(error_of("a.vtp", with(ascii, "header_type",
                                      "compressor=\"vtkLZ4DataCompressor\" "
                                      "header_type")),
               "ZLib");
  EXPECT_TELLS(error_of("a.vtp", ascii.substr(0, ascii.size() / 2)), "truncated");
  EXPECT_TELLS(error_of("a.vtp", "no XML"), "a.vtp");
  const std::string raw = poly_data({"appended raw"}, every_type());
  EXPECT_TELLS(
      error_of("a.vtp", with(raw, "NumberOfPoints=\"9\"", "NumberOfPoints=\"4294967294\"")),
      "bytes instead of");
  EXPECT_TELLS(error_of("a.vtp", raw.substr(0, raw.size() - 40)), "is not whole");
  EXPECT_TELLS(error_of("a.vtu", grid({}, {{0, 1, 9}, {3}}, {5})), "do not exist");
  EXPECT_TELLS(error_of("a.vtu", grid({}, {{0, 1, 2, 3}, {3, 1, 4}}, {5, 5, 5})), "offsets");
}

TEST_F(VtkFile, ArraysThatShareTheirBytesCannotGrowBeyondTheFile) {
  std::string file =
      poly_data({"appended raw"}, {{make_data_array("a", 300, std::vector<float>(2700))}, {}});
  const std::size_t tag = file.find("<DataArray"), end = file.find("/>", tag) + 2;
  const std::string copy = file.substr(tag, end - tag);
  std::string many;
  for (int i = 0; i < 1000; ++i) many += copy;
  EXPECT_NE(error_of("a.vtp", file.insert(end, many)), "");
}

#else

TEST_F(VtkFile, WithoutPugixmlXmlFilesAreRefusedByTheOptionsName) {
  EXPECT_TELLS(error_of("a.vtp", poly_data({}, {})), "BRINDLE_VTK");
  EXPECT_TELLS(error_of("a.vtu", grid({}, kPolys, {9, 5})), "BRINDLE_VTK");
}

#endif  // BRINDLE_HAS_VTK

TEST_F(VtkFile, ReadsLegacyFilesWithArraysOfEveryType) {
  for (const bool binary : {false, true}) {
    for (const int version : {2, 4, 5}) {
      const DataArrays arrays = every_type();
      expect_all(read("a.vtk", legacy(binary, version, arrays)), arrays,
                 (binary ? "binary " : "text ") + std::to_string(version));
    }
  }
}

TEST_F(VtkFile, ReadsEveryKindOfLegacyAttribute) {
  const auto numbers = [](int components, auto first) {
    std::vector<decltype(first)> values(9 * static_cast<std::size_t>(components), first);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += static_cast<decltype(first)>(i);
    return make_data_array("", components, values);
  };
  for (const bool binary : {false, true}) {
    LegacyText text(binary, 4);
    text.line("DATASET UNSTRUCTURED_GRID");
    text.line("FIELD FieldData 1\nTIME 1 1 double")
        .numbers(make_data_array("", 1, std::vector{2.5}));
    text.points().cells("CELLS", kPolys).line("CELL_TYPES 2");
    text.numbers(make_data_array("", 1, std::vector<std::int32_t>{9, 5}));
    text.line("POINT_DATA 9");
    text.line("SCALARS speed float\nLOOKUP_TABLE default").numbers(numbers(1, 0.5f));
    text.line("SCALARS pair double 2\nLOOKUP_TABLE mine").numbers(numbers(2, 0.25));
    text.line("LOOKUP_TABLE mine 2");
    binary ? text.numbers(make_data_array("", 4, std::vector<std::uint8_t>(8, 10)))
           : text.line("0 0 0 1 1 1 1 1");
    text.line("VECTORS velocity float").numbers(numbers(3, 1.0f));
    text.line("NORMALS n double").numbers(numbers(3, 2.0));
    text.line("TENSORS stress float").numbers(numbers(9, 3.0f));
    text.line("TENSORS6 strain float").numbers(numbers(6, 4.0f));
    text.line("TEXTURE_COORDINATES uv 2 float").numbers(numbers(2, 5.0f));
    text.line("COLOR_SCALARS paint 3");
    binary ? text.numbers(make_data_array("", 3, std::vector<std::uint8_t>(27, 255)))
           : text.numbers(make_data_array("", 3, std::vector<float>(27, 1)));
    text.line("GLOBAL_IDS id vtkIdType");
    binary ? text.numbers(numbers(1, std::int32_t{100})) : text.numbers(numbers(1, 100));
    text.line("FIELD more 2\nflags 1 9 bit");
    binary ? text.line("ab") : text.line("0 1 0 1 0 1 0 1 0");
    text.line("labels 1 9 string");
    for (int i = 0; i < 9; ++i)
      text.line(binary ? "\xc3"
                         "abc"
                       : "a%20b");
    std::string file = text.text();
    // Strings of binary files end where their length says.
    for (std::size_t at; binary && (at = file.find("\xc3"
                                                   "abc\n")) != std::string::npos;) {
      file.erase(at + 4, 1);
    }
    const LoadedMesh loaded = read("a.vtk", file);
    const auto expect = [&](const char* name, DataArray array) {
      array.name = name;
      const DataArray* found = find_array(loaded.arrays.points, name);
      ASSERT_NE(found, nullptr) << name;
      EXPECT_EQ(*found, array) << name << (binary ? " binary" : " text");
    };
    expect("speed", numbers(1, 0.5f));
    expect("pair", numbers(2, 0.25));
    expect("velocity", numbers(3, 1.0f));
    expect("n", numbers(3, 2.0));
    expect("stress", numbers(9, 3.0f));
    expect("strain", numbers(6, 4.0f));
    expect("uv", numbers(2, 5.0f));
    expect("paint", make_data_array("", 3, std::vector<std::uint8_t>(27, 255)));
    expect("id", numbers(1, std::int64_t{100}));
    EXPECT_EQ(loaded.arrays.points.size(), 9u);
    EXPECT_TELLS(loaded.left_out, "'flags'");
    EXPECT_TELLS(loaded.left_out, "'labels'");
    EXPECT_EQ(loaded.mesh.triangle_count(), 3u);
  }
}

TEST_F(VtkFile, LegacyErrorsNameTheLine) {
  const std::string file = legacy(false, 4, {});
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = file;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_TELLS(error_of("a.vtk", with("0 1 0\n", "0 x 0\n")), "a.vtk:");
  EXPECT_TELLS(error_of("a.vtk", with("0 1 0\n", "0 x 0\n")), "'x'");
  EXPECT_TELLS(error_of("a.vtk", with("POLYDATA", "STRUCTURED_GRID")), "Extract Surface");
  EXPECT_TELLS(error_of("a.vtk", with("CELL_DATA 9", "CELL_DATA 8")), "9");
  EXPECT_TELLS(error_of("a.vtk", with("POLYGONS 2", "POLYGONS 3")), "cells");
  EXPECT_TELLS(error_of("a.vtk", with("POINTS 9", "POINTS 900000000")), "larger than the file");
  EXPECT_TELLS(error_of("a.vtk", with("# vtk", "# abc")), "DataFile");
  const std::string binary = legacy(true, 5, every_type());
  EXPECT_TELLS(error_of("a.vtk", binary.substr(0, binary.size() - 40)), "truncated");
}

TEST_F(VtkFile, ArraysComeBackFromWhatBrindleWrites) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  std::vector<DataArray> points = arrays_of_every_type(4), cells = arrays_of_every_type(2);
  for (DataArray& array : points) array.name[2] = '_';
  for (DataArray& array : cells) array.name[2] = '_';
  points.push_back(make_data_array("normal", 3, std::vector<float>(12, 1)));
  points.push_back(make_data_array("color", 3, std::vector<std::uint8_t>(12, 200)));
  points.push_back(make_data_array("uv", 2, std::vector<float>(8, 0.25f)));
  std::vector<std::string> names = {"a.ply"};
#ifdef BRINDLE_HAS_VTK
  names.push_back("a.vtp");
#endif
  for (const std::string& name : names) {
    // PLY has no whole numbers of 64 bits.
    const FittedArrays fitted = fitted_arrays(name, {points, cells});
    write_mesh(folder / name, mesh, fitted.arrays.points, fitted.arrays.cells);
    const LoadedMesh loaded = read_mesh(folder / name);
    EXPECT_EQ(loaded.mesh.triangles, mesh.triangles);
    EXPECT_EQ(loaded.arrays, fitted.arrays) << name;
    EXPECT_GE(loaded.arrays.points.size(), name == "a.ply" ? 11u : 13u);
  }
#ifdef BRINDLE_HAS_JSON
  for (const std::string name : {"a.gltf", "a.glb"}) {
    const std::vector<DataArray> arrays = {
        make_data_array("normal", 3, std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0}),
        make_data_array("phase", 1, std::vector<float>{1, 2, 3, 4}),
        make_data_array("uv", 2, std::vector<float>{0, 0.25f, 0.5f, 1, 2, 3, 4, -5})};
    write_mesh(folder / name, mesh, arrays);
    const LoadedMesh loaded = read_mesh(folder / name);
    ASSERT_EQ(loaded.arrays.points.size(), arrays.size());
    for (const DataArray& array : arrays) {
      EXPECT_EQ(*find_array(loaded.arrays.points, array.name), array) << name;
    }
  }
#endif
}

/// A copy with something wrong in it.
std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
  };
  const std::size_t at = below(text.size());
  const std::size_t digit = text.find_first_of("0123456789", at);
  switch (below(7)) {
    case 0:
      text[at] = static_cast<char>(below(256));
      break;
    case 1:
      text.resize(at);
      break;
    case 2:
      text.erase(at, below(200));
      break;
    case 3:
      text.insert(at, text.substr(below(text.size()), below(200)));
      break;
    case 4:
      if (digit != std::string::npos) text[digit] = static_cast<char>('0' + below(10));
      break;
    case 5:
      if (digit != std::string::npos) text.insert(digit, std::to_string(random()));
      break;
    default:
      for (int i = 0; i < 4; ++i) text[below(text.size())] = '\xff';
  }
  return text;
}

TEST_F(VtkFile, MutatedFilesAreReadOrRefused) {
  std::vector<std::pair<std::string, std::string>> files;
  const DataArrays arrays = every_type();
#ifdef BRINDLE_HAS_VTK
  const Cells cells = {{0, 1, 4, 3, 0, 1, 3, 8, 1, 2, 4, 5}, {4, 8, 12}};
  for (const VtkXmlStyle& style :
       {VtkXmlStyle{}, VtkXmlStyle{"binary"}, VtkXmlStyle{"binary", true, true},
        VtkXmlStyle{"appended raw"}, VtkXmlStyle{"appended raw", true, false, true},
        VtkXmlStyle{"appended base64", false, true}, VtkXmlStyle{"appended base64", true}}) {
    files.emplace_back("a.vtp", poly_data(style, arrays));
    files.emplace_back("a.vtu", grid(style, cells, {9, 10, 8}));
  }
#endif
  for (const bool binary : {false, true}) {
    for (const int version : {4, 5}) files.emplace_back("a.vtk", legacy(binary, version, arrays));
  }
  std::mt19937 random(7);
  std::size_t refused = 0, count = 0;
  for (; count < 2600; ++count) {
    const auto& [name, text] = files[count % files.size()];
    const std::string damaged = mutated(mutated(text, random), random);
    try {
      const LoadedMesh loaded = read(name, damaged);
      for (const DataArray& array : loaded.arrays.points) {
        ASSERT_EQ(array.rows(), loaded.mesh.vertex_count());
        ASSERT_LT(array.bytes.size(), 1200 * text.size());
      }
      for (const DataArray& array : loaded.arrays.cells) {
        ASSERT_EQ(array.rows(), loaded.mesh.triangle_count());
      }
      for (const Triangle& t : loaded.mesh.triangles) {
        for (const Index v : t) ASSERT_LT(v, loaded.mesh.vertex_count());
      }
    } catch (const Error& error) {
      ++refused;
      ASSERT_TRUE(std::string(error.what()).find(name) != std::string::npos) << error.what();
    }
  }
  EXPECT_GT(refused, count / 4);
  EXPECT_LT(refused, count);
}

}  // namespace
}  // namespace brindle
