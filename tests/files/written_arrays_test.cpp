#include "brindle/files/written_arrays.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/base/array_numbers.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "test_folder.h"
#include "vtk_texts.h"
#include "written_vtp.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

constexpr NumberType kAllTypes[] = {NumberType::float32, NumberType::float64, NumberType::int8,
                                    NumberType::uint8,   NumberType::int16,   NumberType::uint16,
                                    NumberType::int32,   NumberType::uint32,  NumberType::int64,
                                    NumberType::uint64};
const std::vector<float> kFloats = {1, 2, 3};

/// Bytes without any pattern that a conversion would keep: all extremes and NaNs are among them.
DataArray scrambled(NumberType type, int components, std::size_t rows) {
  DataArray array{
      std::string(name_of(type)) + "_" + std::to_string(components), type, components, {}};
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < rows * static_cast<std::size_t>(components) * size_of(type); ++i) {
    state = state * 1664525 + 1013904223;
    array.bytes.push_back(static_cast<std::byte>(state >> 24));
  }
  return array;
}

std::vector<DataArray> all_kinds(std::size_t rows) {
  std::vector<DataArray> arrays;
  for (const NumberType type : kAllTypes) {
    for (const int components : {1, 2, 3, 6, 9}) {
      arrays.push_back(scrambled(type, components, rows));
    }
  }
  return arrays;
}

Mesh two_triangles() {
  return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, {{0, 1, 2}, {0, 2, 3}}};
}

std::string text_of(const DataArray& array) {
  return {reinterpret_cast<const char*>(array.bytes.data()), array.bytes.size()};
}

std::string load(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream content;
  content << in.rdbuf();
  return content.str();
}

std::vector<std::string> names_of(const std::vector<DataArray>& arrays) {
  std::vector<std::string> names;
  for (const DataArray& array : arrays) names.push_back(array.name);
  return names;
}

struct WrittenArrays : TestFolder {};

TEST_F(WrittenArrays, VtpHoldsEveryTypeAndWidthBitForBit) {
  const std::vector<DataArray> points = all_kinds(4), cells = all_kinds(2);
  write_mesh(folder / "a.vtp", two_triangles(), points, cells);
  const WrittenVtp file{load(folder / "a.vtp")};
  for (const DataArray& array : points) {
    EXPECT_EQ(file.bytes("PointData", array.name), text_of(array)) << array.name;
    EXPECT_NE(file.tag("PointData", array.name)
                  .find("NumberOfComponents=\"" + std::to_string(array.components) + "\""),
              std::string::npos);
  }
  for (const DataArray& array : cells) {
    EXPECT_EQ(file.bytes("CellData", array.name), text_of(array)) << array.name;
  }
  EXPECT_NE(file.tag("PointData", "uint16_3").find("type=\"UInt16\""), std::string::npos);
  EXPECT_NE(file.tag("CellData", "float64_9").find("type=\"Float64\""), std::string::npos);
}

TEST_F(WrittenArrays, PlyHoldsEveryTypeOfItsOwnBitForBit) {
  for (const NumberType type : kAllTypes) {
    if (size_of(type) == 8 && type != NumberType::float64) continue;
    for (const int components : {1, 2, 3, 6, 9}) {
      const DataArray point = scrambled(type, components, 4);
      const DataArray cell = scrambled(type, components, 2);
      write_mesh(folder / "a.ply", two_triangles(), {&point, 1}, {&cell, 1});
      const std::string file = load(folder / "a.ply");
      const std::size_t row = point.bytes.size() / 4;
      const char* body = file.data() + file.find("end_header\n") + 11;
      for (std::size_t v = 0; v < 4; ++v) {
        EXPECT_EQ(std::memcmp(body + v * (12 + row) + 12, &point.bytes[v * row], row), 0);
      }
      const char* faces = body + 4 * (12 + row);
      for (std::size_t t = 0; t < 2; ++t) {
        EXPECT_EQ(std::memcmp(faces + t * (13 + row) + 13, &cell.bytes[t * row], row), 0);
      }
      EXPECT_EQ(faces + 2 * (13 + row), file.data() + file.size());
      EXPECT_EQ(read_mesh(folder / "a.ply").mesh.triangles, two_triangles().triangles);
    }
  }
}

TEST(FittedArrays, PlyHasNo64BitIntegers) {
  const std::int64_t far = std::int64_t{1} << 40, all_digits = (std::int64_t{1} << 60) + 1;
  const FittedArrays fitted = fitted_arrays(
      "a.ply", {{make_data_array("id", 1, std::vector<std::int64_t>{-1, 2}),
                 make_data_array("count", 1, std::vector<std::uint64_t>{1, 4000000000}),
                 make_data_array("far", 1, std::vector<std::int64_t>{0, far}),
                 make_data_array("hash", 1, std::vector<std::int64_t>{0, all_digits})},
                {}});
  const std::vector<DataArray> expected = {
      make_data_array("id", 1, std::vector<std::int32_t>{-1, 2}),
      make_data_array("count", 1, std::vector<std::uint32_t>{1, 4000000000}),
      make_data_array("far", 1, std::vector<double>{0, 1099511627776.0})};
  EXPECT_EQ(fitted.arrays.points, expected);
  EXPECT_EQ(fitted.left_out,
            std::vector<std::string>{"array 'hash' (64-bit numbers) is not kept in .ply"});
}

TEST(FittedArrays, GltfHoldsWhatIsExactAsFloats) {
  const float inf = std::numeric_limits<float>::infinity();
  const FittedArrays fitted = fitted_arrays(
      "a.glb", {{make_data_array("flag", 1, std::vector<std::uint8_t>{0, 255}),
                 make_data_array("my id", 1, std::vector<std::int64_t>{-16777216, 7}),
                 make_data_array("big", 1, std::vector<std::int32_t>{16777217, 0}),
                 make_data_array("third", 1, std::vector<double>{1.0 / 3, 0}),
                 make_data_array("half", 2, std::vector<double>{0.5, 0, 1, 2}),
                 make_data_array("hole", 1, std::vector<float>{0, NAN}),
                 make_data_array("endless", 1, std::vector<double>{static_cast<double>(inf), 0}),
                 make_data_array("stress", 9, std::vector<float>(18))},
                {make_data_array("region", 1, kFloats)}});
  EXPECT_EQ(
      fitted.arrays.points,
      (std::vector<DataArray>{make_data_array("_FLAG", 1, std::vector<float>{0, 255}),
                              make_data_array("_MY_ID", 1, std::vector<float>{-16777216, 7}),
                              make_data_array("_HALF", 2, std::vector<float>{0.5, 0, 1, 2})}));
  EXPECT_TRUE(fitted.arrays.cells.empty());
  EXPECT_EQ(fitted.left_out,
            (std::vector<std::string>{
                "array 'big' (numbers that are no 32-bit floats) is not kept in .glb",
                "array 'third' (numbers that are no 32-bit floats) is not kept in .glb",
                "array 'hole' (numbers that are not finite) is not kept in .glb",
                "array 'endless' (numbers that are not finite) is not kept in .glb",
                "array 'stress' (9 components) is not kept in .glb",
                "array 'region' (per triangle) is not kept in .glb"}));
}

TEST(FittedArrays, ObjHoldsNormalsAndCoordinates) {
  const FittedArrays fitted =
      fitted_arrays("a.obj", {{make_data_array("normal", 3, std::vector<double>{0, 0, 1}),
                               make_data_array("speed", 1, std::vector<float>{1})},
                              {}});
  EXPECT_EQ(names_of(fitted.arrays.points), std::vector<std::string>{"normal"});
  EXPECT_EQ(fitted.left_out,
            std::vector<std::string>{"array 'speed' (1 component) is not kept in .obj"});
}

TEST(FittedArrays, NamesFitTheirFormatAndStayApart) {
  const auto names = [](const char* file, std::vector<std::string> given) {
    DataArrays arrays;
    for (const std::string& name : given)
      arrays.points.push_back(make_data_array(name, 1, kFloats));
    return names_of(fitted_arrays(file, std::move(arrays)).arrays.points);
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names("a.vtp", {"wall <shear> & \"heat\"",
                            "Gr\xc3\xb6\xc3\x9f"
                            "e",
                            "bad \xff\x01", "", "x", "x"}),
            (Names{"wall <shear> & \"heat\"",
                   "Gr\xc3\xb6\xc3\x9f"
                   "e",
                   "bad __", "array", "x", "x_"}));
  EXPECT_EQ(names("a.ply", {"wall shear", "wall_shear", "x", "end_header\nproperty", "\xc3\xb6"}),
            (Names{"wall_shear", "wall_shear_", "x_", "end_header_property", "__"}));
  EXPECT_EQ(names("a.gltf", {"wall shear", "Wall-Shear"}), (Names{"_WALL_SHEAR", "_WALL_SHEAR_"}));
}

TEST(FittedArrays, ColumnsOfDifferentArraysStayApart) {
  const FittedArrays fitted = fitted_arrays(
      "a.ply",
      {{make_data_array("v_x", 1, kFloats), make_data_array("v", 3, kFloats),
        make_data_array("v_1", 1, kFloats), make_data_array("v", 2, std::vector<float>{1, 2})},
       {}});
  EXPECT_EQ(names_of(fitted.arrays.points), (std::vector<std::string>{"v_x", "v_", "v_1", "v_"}));
}

TEST_F(WrittenArrays, NamesAreQuotedInXml) {
  const DataArray array = make_data_array("wall <shear> & \"heat\"", 1, std::vector<float>(4));
  write_mesh(folder / "a.vtp", two_triangles(), {&array, 1});
  const WrittenVtp file{load(folder / "a.vtp")};
  EXPECT_NE(file.tag("PointData", "wall &lt;shear&gt; &amp; &quot;heat&quot;"), "");
}

TEST(ExactlyAs, RefusesWhatWouldBeRounded) {
  const auto exact = [](auto number, NumberType type) {
    return exactly_as(make_data_array("a", 1, std::vector{number}), type).has_value();
  };
  EXPECT_TRUE(exact(std::int64_t{1} << 62, NumberType::float32));
  EXPECT_FALSE(exact(std::numeric_limits<std::int64_t>::max(), NumberType::float64));
  EXPECT_TRUE(exact(std::numeric_limits<std::int64_t>::min(), NumberType::float32));
  EXPECT_FALSE(exact(std::numeric_limits<std::uint64_t>::max(), NumberType::float32));
  EXPECT_FALSE(exact(std::uint64_t{1} << 32, NumberType::uint32));
  EXPECT_FALSE(exact(std::int64_t{-1}, NumberType::uint32));
  EXPECT_FALSE(exact(1e300, NumberType::float32));
  EXPECT_FALSE(exact(1e-300, NumberType::float32));
  EXPECT_FALSE(exact(0.1, NumberType::float32));
  EXPECT_TRUE(exact(0.1f, NumberType::float64));
  EXPECT_FALSE(exact(1.0f, NumberType::int32));
}

TEST_F(WrittenArrays, ArraysOfOtherLengthsAreRefused) {
  DataArray array = make_data_array("a", 1, std::vector<float>(4));
  EXPECT_THROW(write_mesh(folder / "a.vtp", two_triangles(), {}, {&array, 1}), Error);
  array.bytes.pop_back();
  EXPECT_THROW(write_mesh(folder / "a.vtp", two_triangles(), {&array, 1}), Error);
  array.components = 0;
  EXPECT_THROW(write_mesh(folder / "a.vtp", two_triangles(), {&array, 1}), Error);
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(WrittenArrays, ArraysComeBackFromWhatBrindleWrites) {
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

}  // namespace
}  // namespace brindle
