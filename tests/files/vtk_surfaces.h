/// The same surface, with arrays, in every form that VTK's files have.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "test_folder.h"
#include "vtk_texts.h"

namespace brindle {

using Numbers = std::vector<std::int64_t>;

inline const std::vector<float> kPlaces = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1,   1,
                                           0, 2, 1, 0, 0, 2, 0, 1, 2, 0, 2, 2, 0.5f};

/// Cells of one kind.
struct Cells {
  Numbers points, ends;
};

/// All kinds that PolyData has: nine points and nine cells, of which four are surface.
inline const Cells kVerts = {{0, 1, 2}, {1, 3}};
inline const Cells kLines = {{0, 1, 2, 3, 4, 1, 5}, {3, 5, 7}};
inline const Cells kPolys = {{0, 1, 4, 3, 4, 5, 8}, {4, 7}};
inline const Cells kStrips = {{3, 4, 6, 7, 1, 2, 4}, {4, 7}};

inline const std::vector<Triangle> kTriangles = {{0, 1, 4}, {0, 4, 3}, {4, 5, 8},
                                                 {3, 4, 6}, {6, 4, 7}, {1, 2, 4}};
inline const std::vector<Index> kCellOfTriangle = {5, 5, 6, 7, 7, 8};

inline DataArray places() { return make_data_array("Points", 3, kPlaces); }

inline std::string cells_xml(VtkXmlText& text, const std::string& element, const Cells& cells) {
  return text.arrays(element, {make_data_array("connectivity", 1, cells.points),
                               make_data_array("offsets", 1, cells.ends)});
}

/// Several times the same piece.
inline std::string poly_data(const VtkXmlStyle& style, const DataArrays& arrays, int pieces = 1) {
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

inline std::string grid(const VtkXmlStyle& style, const Cells& cells,
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

inline DataArrays every_type(bool nan = true) {
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

inline std::string legacy(bool binary, int version, const DataArrays& arrays) {
  LegacyText text(binary, version);
  text.line("DATASET POLYDATA").points();
  text.cells("VERTICES", kVerts).cells("TRIANGLE_STRIPS", kStrips).cells("LINES", kLines);
  text.cells("POLYGONS", kPolys).line("CELL_DATA 9").field(arrays.cells);
  return text.line("POINT_DATA 9").field(arrays.points).text();
}

/// A test of files that hold all kinds of cells.
struct VtkFile : TestFolder {
  std::filesystem::path save(const std::string& name, const std::string& content) const {
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

}  // namespace brindle
