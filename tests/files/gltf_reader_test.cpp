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

const std::vector<float> kOneWeight = {1, 0, 0, 0};

std::vector<float> repeated(const std::vector<float>& row, std::size_t times) {
  std::vector<float> rows;
  for (std::size_t i = 0; i < times; ++i) rows.insert(rows.end(), row.begin(), row.end());
  return rows;
}

// glTF 2.0, 3.7.3.3: only the joints' transforms apply.
TEST_F(GltfReading, SkinnedMeshesFollowTheirJointsAndNotTheirNode) {
  GltfText text;
  const auto position = text.add(kTriangle, "VEC3", 5126);
  const auto normal = text.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 5126);
  const auto joints =
      text.add(std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 5121);
  const auto weights =
      text.add(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, .75f, .25f, 0, 0}, "VEC4", 5126);
  // The second joint is bound two to the right of where it stands.
  std::vector<float> bind = repeated({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 2);
  bind[16 + 12] = -2;
  text.file["accessors"].push_back({});
  const auto matrices = text.file["accessors"].size() - 1;
  const auto raw = text.add(bind, "VEC4", 5126);
  text.file["accessors"][matrices] = text.file["accessors"][raw];
  text.file["accessors"][matrices].update({{"type", "MAT4"}, {"count", 2}});
  text.add_primitive(
      {{"POSITION", position}, {"NORMAL", normal}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
  text.file["nodes"] = {
      {{"mesh", 0}, {"skin", 0}, {"scale", {10, 1, 1}}, {"translation", {9, 0, 0}}},
      {{"children", {2}}, {"translation", {0, 0, 3}}},
      {{"rotation", {1, 0, 0, 0}}}};
  text.file["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}};
  const LoadedMesh loaded = read(text);
  // The second joint is turned by half a turn about x: (x, y, z) to (x - 2, -y, 3 - z).
  EXPECT_EQ(loaded.mesh.positions, (std::vector<Vec3>{{0, 0, 3}, {-1, 0, 3}, {-.5f, .5f, 3}}));
  const std::vector<Vec3> normals =
      vectors_of(find_array(loaded.arrays.points, "normal")->view(), "normals");
  EXPECT_EQ(normals[0], Vec3(0, 0, 1));
  EXPECT_EQ(normals[1], Vec3(0, 0, -1));
}

TEST_F(GltfReading, SkinsThatMakeNoSenseAreErrors) {
  const auto skinned = [&](int joint, const json& skin, int node_skin) {
    GltfText text;
    text.add_primitive(
        {{"POSITION", text.add(kTriangle, "VEC3", 5126)},
         {"JOINTS_0",
          text.add(std::vector<std::uint8_t>(12, static_cast<std::uint8_t>(joint)), "VEC4", 5121)},
         {"WEIGHTS_0", text.add(repeated(kOneWeight, 3), "VEC4", 5126)}});
    text.file["nodes"][0]["skin"] = node_skin;
    text.file["skins"] = json::array({skin});  // in braces alone compilers differ
    std::ofstream(folder / "data.bin", std::ios::binary) << text.data();
    return error_of(text.text("data.bin"));
  };
  EXPECT_EQ(skinned(0, {{"joints", {0}}}, 0), "");
  EXPECT_NE(skinned(1, {{"joints", {0}}}, 0), "");
  EXPECT_NE(skinned(0, {{"joints", {7}}}, 0), "");
  EXPECT_NE(skinned(0, {{"joints", {0}}}, 1), "");
  EXPECT_NE(skinned(0, {{"joints", {0}}, {"inverseBindMatrices", 0}}, 0), "");
}

TEST_F(GltfReading, WeightsOfMorphTargetsAreSaidToBeLeftOut) {
  for (const bool own : {false, true}) {
    GltfText text;
    const auto position = text.add(kTriangle, "VEC3", 5126);
    text.add_primitive({{"POSITION", position}}, {{"targets", {{{"POSITION", position}}}}});
    EXPECT_EQ(read(text).left_out, "");
    text.file["meshes"][0]["weights"] = {own ? 0.0 : 0.5};
    if (own) text.file["nodes"][0]["weights"] = {0.25};
    EXPECT_NE(read(text).left_out.find("morph targets"), std::string::npos);
  }
}

TEST_F(GltfReading, InstancesAreMeshesOfTheirOwn) {
  GltfText text;
  text.file["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  text.add_primitive({{"POSITION", text.add(kTriangle, "VEC3", 5126)}});
  const auto translation = text.add(std::vector<float>{0, 0, 0, 0, 0, 3}, "VEC3", 5126);
  const auto rotation =
      text.add(std::vector<std::int8_t>{0, 0, 0, 127, 0, 0, 127, 0}, "VEC4", 5120, true);
  const auto scale = text.add(std::vector<float>{1, 1, 1, 2, 2, 2}, "VEC3", 5126);
  text.file["nodes"][0]["translation"] = {5, 0, 0};
  json& attributes = text.file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes = {{"TRANSLATION", translation}, {"ROTATION", rotation}, {"SCALE", scale}};
  const LoadedMesh loaded = read(text);
  EXPECT_EQ(loaded.mesh.positions,
            (std::vector<Vec3>{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 3}, {3, 0, 3}, {5, -2, 3}}));
  EXPECT_EQ(loaded.mesh.triangle_count(), 2u);
  attributes["SCALE"] = 0;  // of three vertices
  std::ofstream(folder / "data.bin", std::ios::binary) << text.data();
  EXPECT_NE(error_of(text.text("data.bin")), "");
}

TEST_F(GltfReading, RequiredExtensionsThatMayChangeTheMeshAreRefusedByName) {
  GltfText text;
  text.add_primitive({{"POSITION", text.add(kTriangle, "VEC3", 5126)}});
  std::ofstream(folder / "data.bin", std::ios::binary) << text.data();
  text.file["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_transform"};
  EXPECT_EQ(error_of(text.text("data.bin")), "");
  text.file["extensionsRequired"].push_back("ACME_teapots");
  EXPECT_NE(error_of(text.text("data.bin")).find("'ACME_teapots'"), std::string::npos);
}

TEST_F(GltfReading, OtherVersionsAreNamed) {
  EXPECT_NE(error_of(R"({"asset":{"version":"1.0"},"bufferViews":{}})").find("version 1.0"),
            std::string::npos);
}

TEST_F(GltfReading, SparseAccessorsAreReadAndMayBeUnused) {
  GltfText text;
  const auto position = text.add(kTriangle, "VEC3", 5126);
  const auto indices = text.add(std::vector<std::uint16_t>{2, 1}, "SCALAR", 5123);
  const auto values = text.add(std::vector<float>{0, 7, 0, 5, 0, 1}, "VEC3", 5126);
  const json sparse = {{"count", 2},
                       {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                       {"values", {{"bufferView", values}}}};
  json& accessors = text.file["accessors"];
  json on_view = accessors[position], on_zeros = accessors[position];
  on_view["sparse"] = on_zeros["sparse"] = sparse;
  on_zeros.erase("bufferView");
  accessors.push_back(on_view);
  accessors.push_back(on_zeros);
  text.add_primitive({{"POSITION", position}}, {{"targets", {{{"POSITION", 4}}}}});
  EXPECT_EQ(read(text).mesh.vertex_count(), 3u);
  text.file["meshes"][0]["primitives"] = json::array();
  text.add_primitive({{"POSITION", 3}});
  text.add_primitive({{"POSITION", 4}});
  EXPECT_EQ(read(text).mesh.positions,
            (std::vector<Vec3>{{0, 0, 0}, {5, 0, 1}, {0, 7, 0}, {0, 0, 0}, {5, 0, 1}, {0, 7, 0}}));
  const std::vector<std::pair<std::string, json>> changes = {
      {"count", 4},
      {"count", 0},
      {"count", 3},
      {"indices", {{"bufferView", values}, {"byteOffset", 4}, {"componentType", 5123}}},
      {"indices", {{"bufferView", indices}, {"componentType", 5126}}},
      {"indices", {{"bufferView", 99}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}, {"byteOffset", 4}}}};
  for (const auto& [key, value] : changes) {
    text.file["accessors"][3]["sparse"] = sparse;
    text.file["accessors"][3]["sparse"][key] = value;
    EXPECT_NE(error_of(text.text("data.bin")), "") << key << value;
  }
}

}  // namespace
}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
