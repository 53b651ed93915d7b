#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/vtk/vtk_file.h"
#include "vtk_surfaces.h"

namespace brindle {
namespace {

struct VtkLegacyFile : VtkFile {};

TEST_F(VtkLegacyFile, ReadsLegacyFilesWithArraysOfEveryType) {
  for (const bool binary : {false, true}) {
    for (const int version : {2, 4, 5}) {
      const DataArrays arrays = every_type();
      expect_all(read("a.vtk", legacy(binary, version, arrays)), arrays,
                 (binary ? "binary " : "text ") + std::to_string(version));
    }
  }
}

TEST_F(VtkLegacyFile, ReadsEveryKindOfLegacyAttribute) {
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

TEST_F(VtkLegacyFile, FilesThatListNoCellsArePoints) {
  const std::string file =
      "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
      "0 0 0 1 0 0 0 1 0\nPOLYGONS 0 0\n";
  EXPECT_TELLS(error_of("a.vtk", file), "no triangles");
  EXPECT_TRUE(is_point_file(folder / "a.vtk"));
  EXPECT_EQ(read_points(folder / "a.vtk").cloud.positions.size(), 3u);
}

TEST_F(VtkLegacyFile, LegacyErrorsNameTheLine) {
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

}  // namespace
}  // namespace brindle
