#ifdef BRINDLE_HAS_JSON

#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/gltf/gltf_file.h"
#include "test_folder.h"

namespace brindle {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A glTF file put together from arrays of numbers.
class GltfText {
 public:
  /// The number of an accessor with these numbers.
  template <class Number>
  std::size_t add(const std::vector<Number>& numbers, const std::string& type, int component,
                  bool normalized = false, std::size_t stride = 0) {
    const std::size_t row = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    const std::size_t begin = data_.size(), step = std::max(stride, row * sizeof(Number));
    for (std::size_t at = 0; at < numbers.size(); at += row) {
      data_.append(reinterpret_cast<const char*>(&numbers[at]), row * sizeof(Number));
      data_.resize(begin + (at / row + 1) * step);
    }
    json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", data_.size() - begin}};
    if (stride > 0) view["byteStride"] = stride;
    file["bufferViews"].push_back(view);
    json accessor = {{"bufferView", file["bufferViews"].size() - 1},
                     {"componentType", component},
                     {"count", numbers.size() / row},
                     {"type", type}};
    if (normalized) accessor["normalized"] = true;
    file["accessors"].push_back(accessor);
    return file["accessors"].size() - 1;
  }

  void add_primitive(const json& attributes, const json& more = json::object()) {
    json primitive = {{"attributes", attributes}};
    primitive.update(more);
    file["meshes"][0]["primitives"].push_back(primitive);
  }

  std::string text(const std::string& uri) {
    file["buffers"] = {{{"byteLength", data_.size()}, {"uri", uri}}};
    return file.dump();
  }

  const std::string& data() const { return data_; }

  json file = {{"asset", {{"version", "2.0"}}}, {"nodes", {{{"mesh", 0}}}}};

 private:
  std::string data_;
};

struct GltfReading : TestFolder {
  LoadedMesh read(GltfText& text) const {
    std::ofstream(folder / "data.bin", std::ios::binary) << text.data();
    return read(text.text("data.bin"));
  }
  LoadedMesh read(const std::string& text) const {
    std::ofstream(folder / "a.gltf", std::ios::binary) << text;
    return read_mesh(folder / "a.gltf");
  }
  std::string error_of(const std::string& text) const {
    try {
      read(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST_F(GltfReading, PrimitivesThatShareAllAttributesShareVertices) {
  GltfText text;
  const std::size_t position = text.add(kTriangle, "VEC3", 5126);
  const std::size_t one = text.add(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2", 5126);
  const std::size_t other = text.add(std::vector<float>{.5, .5, .6f, .5, .5, .6f}, "VEC2", 5126);
  text.add_primitive({{"POSITION", position}, {"TEXCOORD_0", one}});
  text.add_primitive({{"POSITION", position}, {"TEXCOORD_0", other}});
  text.add_primitive({{"POSITION", position}, {"TEXCOORD_0", one}});
  text.file["nodes"][0]["translation"] = {0, 0, 7};
  const LoadedMesh loaded = read(text);
  EXPECT_EQ(loaded.mesh.vertex_count(), 6u);
  const std::vector<float> expected = {0, 1, 1, 1, 0, 0, .5, .5, .6f, .5, .5, 1 - .6f};
  EXPECT_EQ(*find_array(loaded.arrays.points, "uv"), make_data_array("uv", 2, expected));
}

TEST_F(GltfReading, WholeNumbersStandForCoordinates) {
  GltfText text;
  text.file["extensionsUsed"] = {"KHR_mesh_quantization"};
  const auto bytes = text.add(std::vector<std::int8_t>{0, 0, -128, 127, 0, -127, 0, 127, 0}, "VEC3",
                              5120, true, 4);
  const auto shorts =
      text.add(std::vector<std::uint16_t>{0, 0, 0, 300, 0, 0, 0, 65535, 0}, "VEC3", 5123, false, 8);
  const auto normal =
      text.add(std::vector<std::int8_t>{0, 0, 127, 0, 0, -128, 127, 0, 0}, "VEC3", 5120, true, 4);
  const auto half = text.add(std::vector<std::uint8_t>{0, 0, 255, 0, 0, 51}, "VEC2", 5121, true, 4);
  const auto whole = text.add(std::vector<std::int16_t>{0, 0, 3, 0, 0, -4}, "VEC2", 5122);
  text.add_primitive({{"POSITION", bytes}, {"NORMAL", normal}, {"TEXCOORD_0", half}});
  text.add_primitive({{"POSITION", shorts}, {"NORMAL", normal}, {"TEXCOORD_0", whole}});
  const LoadedMesh loaded = read(text);
  EXPECT_EQ(loaded.mesh.positions,
            (std::vector<Vec3>{
                {0, 0, -1}, {1, 0, -1}, {0, 1, 0}, {0, 0, 0}, {300, 0, 0}, {0, 65535, 0}}));
  EXPECT_EQ(
      vectors_of(find_array(loaded.arrays.points, "normal")->view(), "normals"),
      (std::vector<Vec3>{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {1, 0, 0}}));
  const std::vector<float> uv = {0, 1, 1, 1, 0, 1 - .2f, 0, 1, 3, 1, 0, 5};
  EXPECT_EQ(*find_array(loaded.arrays.points, "uv"), make_data_array("uv", 2, uv));
}

// A few hundred bytes ask for as much as they like.
TEST_F(GltfReading, WhatHasNoDataIsLeftOut) {
  GltfText text;
  const std::size_t position = text.add(kTriangle, "VEC3", 5126);
  text.file["accessors"].push_back(
      {{"componentType", 5126}, {"count", 4000000000}, {"type", "VEC3"}});
  text.file["accessors"].push_back(
      {{"componentType", 5125}, {"count", 4000000000}, {"type", "SCALAR"}});
  text.add_primitive({{"POSITION", position}});
  text.add_primitive({{"POSITION", 1}});
  text.add_primitive({{"POSITION", position}}, {{"indices", 2}});
  const LoadedMesh loaded = read(text);
  EXPECT_EQ(loaded.mesh.triangle_count(), 1u);
  EXPECT_NE(loaded.left_out.find("2 primitives: left out"), std::string::npos) << loaded.left_out;
}

/// What is said of a file that may not have more than the bounds; empty if nothing is.
std::string refusal_within(const GltfBounds& bounds, const fs::path& file) {
  try {
    read_gltf(file, {}, bounds);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// 100 copies of 12 kB of data, which are three times as large in memory.
TEST_F(GltfReading, LittleThatIsRepeatedTooOftenIsRefused) {
  GltfText text;
  const std::size_t position = text.add(std::vector<float>(3000), "VEC3", 5126);
  text.add_primitive({{"POSITION", position}});
  text.file["nodes"] = json::array();
  for (int node = 0; node < 100; ++node) text.file["nodes"].push_back({{"mesh", 0}});
  std::ofstream(folder / "data.bin", std::ios::binary) << text.data();
  std::ofstream(folder / "a.gltf", std::ios::binary) << text.text("data.bin");
  const fs::path file = folder / "a.gltf";
  const std::uint64_t all = 100 * (1000 * (sizeof(Eigen::Vector3d) + sizeof(Triangle)) + 64);
  EXPECT_NE(refusal_within({all - 1, 0}, file).find("fewer copies"), std::string::npos);
  EXPECT_EQ(refusal_within({all, 0}, file), "");
  // A larger file may have more: 300.5 times as much as its data and what its first primitive is.
  EXPECT_NE(refusal_within({64, 300}, file).find("300 times its size"), std::string::npos);
  EXPECT_EQ(refusal_within({64, 301}, file), "");
  // Primitives that show nothing take time, too.
  text.file["meshes"][0]["primitives"] = json::array();
  for (int i = 0; i < 100; ++i) text.add_primitive(json::object(), {{"mode", 4}});
  std::ofstream(file, std::ios::binary) << text.text("data.bin");
  EXPECT_NE(refusal_within({100 * 100 * 64 - 1, 0}, file).find("fewer copies"), std::string::npos);
  EXPECT_EQ(refusal_within({100 * 100 * 64, 0}, file).find("fewer copies"), std::string::npos);
}

// What `read_mesh` asks for: what fits twice into a small computer's memory.
TEST_F(GltfReading, BoundsAreTwoGibibytesAndTwentyTimesTheData) {
  EXPECT_EQ(GltfBounds().bytes, std::uint64_t{2} << 30);
  EXPECT_EQ(GltfBounds().repeats, 20u);
}

// With a parser that looks back over all objects for each, this takes minutes.
TEST_F(GltfReading, ManyObjectsTakeNoLongerThanTheirNumber) {
  GltfText text;
  text.add_primitive({{"POSITION", text.add(kTriangle, "VEC3", 5126)}});
  json& extras = text.file["extras"] = json::array();
  for (int i = 0; i < 300000; ++i) extras.push_back({{"a", i}});
  EXPECT_EQ(read(text).mesh.triangle_count(), 1u);
}

TEST_F(GltfReading, BuffersLieInTheFolderOfTheFile) {
  GltfText text;
  text.add_primitive({{"POSITION", text.add(kTriangle, "VEC3", 5126)}});
  fs::create_directories(folder / "parts");
  for (const char* name : {"parts/a b.bin", "data.bin"}) {
    std::ofstream(folder / name, std::ios::binary) << text.data();
  }
  std::ofstream(folder.parent_path() / "brindle_outside.bin", std::ios::binary) << text.data();
  for (const char* uri : {"parts/a%20b.bin", "parts/a b.bin", "./data.bin", "parts/../data.bin"}) {
    EXPECT_EQ(read(text.text(uri)).mesh.triangle_count(), 1u) << uri;
    const std::vector<fs::path> files = gltf_buffer_files(folder / "a.gltf");
    ASSERT_EQ(files.size(), 1u) << uri;
    EXPECT_TRUE(fs::exists(files[0])) << files[0];
  }
  const std::string absolute = fs::absolute(folder / "data.bin").string();
  for (const std::string& uri :
       {std::string("../brindle_outside.bin"), std::string("%2e%2e/brindle_outside.bin"),
        std::string("parts/../../brindle_outside.bin"), absolute, "file://" + absolute,
        std::string("data.bin%00"), std::string("https://example.org/a.bin"), std::string("")}) {
    EXPECT_NE(error_of(text.text(uri)).find("not in its own folder"), std::string::npos) << uri;
    EXPECT_TRUE(gltf_buffer_files(folder / "a.gltf").empty()) << uri;
  }
  EXPECT_NE(error_of(text.text("none.bin")).find("none.bin: there is no such file"),
            std::string::npos);
  fs::remove(folder.parent_path() / "brindle_outside.bin");
}

TEST_F(GltfReading, BuffersOfOneNameAreReadOnce) {
  GltfText text;
  text.add_primitive({{"POSITION", text.add(kTriangle, "VEC3", 5126)}});
  json file = json::parse(text.text("data.bin"));
  std::ofstream(folder / "data.bin", std::ios::binary) << text.data() << std::string(1 << 20, '\0');
  for (int b = 1; b < 5000; ++b) {  // five gigabytes, if each were read
    file["buffers"].push_back(file["buffers"][0]);
    file["bufferViews"].push_back(file["bufferViews"][0]);
    file["bufferViews"].back()["buffer"] = b;
    file["accessors"].push_back(file["accessors"][0]);
    file["accessors"].back()["bufferView"] = b;
    file["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", b}}}});
  }
  EXPECT_EQ(read(file.dump()).mesh.vertex_count(), 15000u);
}

}  // namespace
}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
