#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/vtk/vtk_file.h"
#include "vtk_surfaces.h"

namespace brindle {
namespace {

struct VtkXmlFile : VtkFile {};

#ifdef BRINDLE_HAS_VTK

std::string name_of_style(const VtkXmlStyle& style) {
  return style.format + (style.zlib ? ", zlib" : "") + (style.wide ? ", UInt64" : "") +
         (style.big_endian ? ", big endian" : "");
}

TEST_F(VtkXmlFile, ReadsPolyDataWithArraysOfEveryTypeInEveryEncoding) {
  const DataArrays arrays = every_type();
  for (const VtkXmlStyle& style : vtk_xml_styles()) {
    expect_all(read("a.vtp", poly_data(style, arrays)), arrays, name_of_style(style));
  }
}

TEST_F(VtkXmlFile, PiecesFollowEachOther) {
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

TEST_F(VtkXmlFile, ArraysThatAPieceLacksAreLeftOutAndNamed) {
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

TEST_F(VtkXmlFile, ReadsTheSurfaceCellsOfGrids) {
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

TEST_F(VtkXmlFile, EmptyCompressedBlocksAreAnError) {
  std::string header;  // one block of 108 bytes that takes none
  for (const std::uint32_t word : {1, 108, 0, 0}) header += bytes_of(word);
  const std::string file =
      "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" "
      "compressor=\"vtkZLibDataCompressor\"><PolyData><Piece NumberOfPoints=\"9\"><Points>"
      "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"binary\">" +
      base64_of(header) + "</DataArray></Points></Piece></PolyData></VTKFile>";
  EXPECT_TELLS(error_of("a.vtp", file), "damaged");
}

TEST_F(VtkXmlFile, VolumesOfUnknownFacesAloneAreRefusedWithTheRemedy) {
  const std::string file = grid({}, {{0, 1, 3, 8}, {4}}, {42});
  EXPECT_TELLS(error_of("a.vtu", file), "Extract Surface");
  EXPECT_FALSE(is_point_file(folder / "a.vtu"));
  EXPECT_EQ(read_points(folder / "a.vtu").cloud.positions.size(), 9u);
}

TEST_F(VtkXmlFile, FilesWithoutSurfaceAreFilesOfPoints) {
  const DataArrays arrays = {arrays_of_every_type(9), {}};
  VtkXmlText text({"appended raw"});
  const std::string piece = "<Piece NumberOfPoints=\"9\">" +
                            text.arrays("PointData", arrays.points) +
                            text.arrays("Points", {places()}) + "</Piece>";
  const std::string with_normals = std::string("<PointData Normals=\"of float64\">");
  std::string named = piece;
  named.replace(named.find("<PointData>"), 11, with_normals);
  for (const std::filesystem::path& path :
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

TEST_F(VtkXmlFile, NormalsOfPointsAreTheirs) {
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

TEST_F(VtkXmlFile, RowsFollowTheirTrianglesThroughRepairs) {
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

TEST_F(VtkXmlFile, NamesAreAsInTheFileAndDifferent) {
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

TEST_F(VtkXmlFile, WhatIsNoNumberIsLeftOutAndNamed) {
  std::string file = poly_data({}, every_type());
  file.insert(file.find("<PointData>") + 11,
              "<Array type=\"String\" Name=\"labels\" format=\"ascii\">65 0 </Array>");
  const LoadedMesh loaded = read("a.vtp", file);
  EXPECT_EQ(loaded.arrays.points.size(), 10u);
  EXPECT_TELLS(loaded.left_out, "'labels'");
}

TEST_F(VtkXmlFile, ErrorsNameTheArrayAndTheRemedy) {
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

TEST_F(VtkXmlFile, ArraysThatShareTheirBytesCannotGrowBeyondTheFile) {
  std::string file =
      poly_data({"appended raw"}, {{make_data_array("a", 300, std::vector<float>(2700))}, {}});
  const std::size_t tag = file.find("<DataArray"), end = file.find("/>", tag) + 2;
  const std::string copy = file.substr(tag, end - tag);
  std::string many;
  for (int i = 0; i < 1000; ++i) many += copy;
  EXPECT_NE(error_of("a.vtp", file.insert(end, many)), "");
}

#else

TEST_F(VtkXmlFile, WithoutPugixmlXmlFilesAreRefusedByTheOptionsName) {
  EXPECT_TELLS(error_of("a.vtp", poly_data({}, {})), "BRINDLE_VTK");
  EXPECT_TELLS(error_of("a.vtu", grid({}, kPolys, {9, 5})), "BRINDLE_VTK");
}

#endif  // BRINDLE_HAS_VTK

}  // namespace
}  // namespace brindle
