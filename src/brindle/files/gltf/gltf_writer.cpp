#include "brindle/error.h"
#include "brindle/files/gltf/gltf_file.h"

#ifdef BRINDLE_HAS_JSON

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/base/base64.h"
#include "brindle/files.h"
#include "brindle/files/gltf/gltf_document.h"

namespace brindle {
namespace {

using Json = nlohmann::json;

/// An array in a file's buffer.
struct Block {
  std::string name;  ///< of the attribute; empty for indices and images
  const void* data;
  std::uint64_t size;  ///< bytes
  std::uint64_t count;
  int components;
};

std::string semantic_of(const DataArray& array) {
  if (is_normal(array)) return "NORMAL";
  if (is_color(array)) return "COLOR_0";
  return is_uv(array) ? "TEXCOORD_0" : array.name;
}

std::vector<Block> blocks_of(const Mesh& mesh, std::span<const DataArray> arrays) {
  const std::uint64_t vertices = mesh.vertex_count(), corners = 3 * mesh.triangle_count();
  static_assert(sizeof(Vec3) == 12 && sizeof(Triangle) == 12);
  std::vector<Block> blocks = {{"", mesh.triangles.data(), 4 * corners, corners, 1},
                               {"POSITION", mesh.positions.data(), 12 * vertices, vertices, 3}};
  for (const DataArray& a : arrays) {
    blocks.push_back({semantic_of(a), a.bytes.data(), a.bytes.size(), vertices, a.components});
  }
  return blocks;
}

/// Texture coordinates with V down, as in glTF.
std::vector<DataArray> with_v_down(std::span<const DataArray> arrays) {
  std::vector<DataArray> turned(arrays.begin(), arrays.end());
  for (DataArray& array : turned) {
    if (!is_uv(array)) continue;
    std::vector<float> numbers = numbers_of(
        ArrayView(reinterpret_cast<const float*>(array.bytes.data()), 2 * array.rows(), 1), "uv");
    for (std::size_t i = 1; i < numbers.size(); i += 2) numbers[i] = 1 - numbers[i];
    array = make_data_array("uv", 2, numbers);
  }
  return turned;
}

/// Adds a material with the image, whose bytes follow the blocks, and assigns it to the mesh.
void add_picture(Json& json, std::uint64_t offset, std::uint64_t size) {
  constexpr int kRepeat = 10497, kLinear = 9729, kLinearMipmapLinear = 9987;
  json["images"] = {{{"bufferView", json["bufferViews"].size()}, {"mimeType", "image/png"}}};
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
  json["samplers"] = {{{"magFilter", kLinear},
                       {"minFilter", kLinearMipmapLinear},
                       {"wrapS", kRepeat},
                       {"wrapT", kRepeat}}};
  json["textures"] = {{{"sampler", 0}, {"source", 0}}};
  json["materials"] = {
      {{"name", "brindle"},
       {"doubleSided", true},
       {"pbrMetallicRoughness",
        {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}}}}};
  json["meshes"][0]["primitives"][0]["material"] = 0;
}

const char* type_of(int components) {
  constexpr std::array<const char*, 4> kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  return kTypes.at(static_cast<std::size_t>(components - 1));
}

Json describe(const Mesh& mesh, const std::vector<Block>& blocks, std::uint64_t size) {
  Json json = {{"asset", {{"version", "2.0"}, {"generator", "brindle"}}},
               {"scene", 0},
               {"scenes", {{{"nodes", {0}}}}},
               {"nodes", {{{"mesh", 0}}}},
               {"buffers", {{{"byteLength", size}}}}};
  Json attributes = Json::object();
  std::uint64_t offset = 0;
  for (const Block& block : blocks) {
    const bool indices = block.name.empty();
    if (!indices) attributes[block.name] = json["accessors"].size();
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size()},
                                 {"componentType", indices ? 5125 : 5126},
                                 {"count", block.count},
                                 {"type", type_of(block.components)}});
    json["bufferViews"].push_back({{"buffer", 0},
                                   {"byteOffset", offset},
                                   {"byteLength", block.size},
                                   {"target", indices ? 34963 : 34962}});
    offset += block.size;
  }
  Vec3 lower = mesh.positions[0], upper = lower;
  for (const Vec3& p : mesh.positions) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  json["accessors"][1]["min"] = {lower[0], lower[1], lower[2]};
  json["accessors"][1]["max"] = {upper[0], upper[1], upper[2]};
  json["meshes"] = {{{"primitives", {{{"attributes", attributes}, {"indices", 0}}}}}};
  if (!mesh.origin.isZero(0)) {
    json["nodes"][0]["translation"] = {mesh.origin.x(), mesh.origin.y(), mesh.origin.z()};
  }
  return json;
}

void write_word(OutputStream& out, std::uint64_t word) {
  const auto narrow = static_cast<std::uint32_t>(word);
  out.write(reinterpret_cast<const char*>(&narrow), 4);
}

void write_text(OutputStream& out, Json json, const std::vector<Block>& blocks) {
  constexpr std::string_view kMark = "@";
  json["buffers"][0]["uri"] = kMark;
  const std::string text = json.dump();
  const std::size_t mark = text.find("\"@\"") + 1;
  out << text.substr(0, mark) << "data:application/octet-stream;base64,";
  Base64Writer base64(out);
  for (const Block& block : blocks) base64.put(block.data, block.size);
  base64.finish();
  out << text.substr(mark + kMark.size()) << '\n';
}

void write_binary(OutputStream& out, const Json& json, const std::vector<Block>& blocks,
                  std::uint64_t size) {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  write_word(out, kGltfMagic);
  write_word(out, 2);
  write_word(out, 12 + 8 + text.size() + 8 + size);
  write_word(out, text.size());
  write_word(out, kGltfJsonChunk);
  out << text;
  write_word(out, size);
  write_word(out, kGltfDataChunk);
  for (const Block& block : blocks) {
    out.write(static_cast<const char*>(block.data), block.size);
  }
}

}  // namespace

void write_gltf(OutputStream& out, const Mesh& mesh, std::span<const DataArray> arrays,
                GltfKind kind, const std::string& png) {
  if (mesh.triangles.empty()) {
    throw Error("glTF cannot hold a mesh without triangles; choose PLY or OBJ");
  }
  const std::vector<DataArray> stored = with_v_down(arrays);
  std::vector<Block> blocks = blocks_of(mesh, stored);
  std::uint64_t size = 0;
  for (const Block& block : blocks) size += block.size;
  const std::uint64_t picture_size = (png.size() + 3) / 4 * 4;
  if (size + picture_size > 0xf0000000) throw Error("the mesh is too large for glTF; choose PLY");
  Json json = describe(mesh, blocks, size + picture_size);
  std::string padded = png;
  padded.resize(picture_size);
  if (!png.empty()) {
    add_picture(json, size, png.size());
    blocks.push_back({"", padded.data(), picture_size, 1, 1});
  }
  if (kind == GltfKind::text) {
    write_text(out, json, blocks);
  } else {
    write_binary(out, json, blocks, size + picture_size);
  }
}

}  // namespace brindle

#else

namespace brindle {
namespace {

[[noreturn]] void refuse() {
  throw Error(
      "this brindle was built without nlohmann-json and so without glTF; choose PLY or OBJ");
}

}  // namespace

void write_gltf(OutputStream&, const Mesh&, std::span<const DataArray>, GltfKind,
                const std::string&) {
  refuse();
}

}  // namespace brindle

#endif
