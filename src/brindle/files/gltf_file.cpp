#include "brindle/files/gltf_file.h"

#include "brindle/error.h"

#ifdef BRINDLE_HAS_JSON

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/base/file_extension.h"
#include "brindle/base/printable.h"
#include "brindle/files/input_file.h"

namespace brindle {
namespace {

using Json = nlohmann::json;

constexpr std::uint32_t kMagic = 0x46546c67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;  // "JSON"
constexpr std::uint32_t kDataChunk = 0x004e4942;  // "BIN"
constexpr int kDeepest = 200;                     ///< nesting of JSON and of nodes

std::uint32_t read_word(InputFile& file) {
  std::uint32_t word = 0;
  std::memcpy(&word, file.take(4), 4);
  return word;
}

struct Document {
  Json json;
  std::uint64_t data_size = 0;  ///< of a GLB's own buffer
};

Json parse(const InputFile& file, const char* text, std::size_t size) {
  const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > kDeepest) file.fail_whole("is nested too deeply for a glTF file");
    return true;
  };
  try {
    Json json = Json::parse(text, text + size, shallow);
    if (!json.is_object()) file.fail_whole("is not a glTF file: its JSON is no object");
    return json;
  } catch (const Json::exception& error) {
    file.fail_whole("holds damaged or truncated JSON, export it again: " + printable(error.what()));
  }
}

Document read_glb(InputFile& file) {
  const std::uint64_t size = file.remaining();
  if (read_word(file) != kMagic)
    file.fail_whole("is not a GLB file: it does not begin with 'glTF'");
  if (read_word(file) != 2) file.fail_whole("is not of glTF version 2; convert it");
  if (read_word(file) > size) {
    file.fail_whole("is shorter than its header says: it is truncated; copy or export it again");
  }
  const std::uint32_t json_size = read_word(file);
  if (read_word(file) != kJsonChunk || json_size > file.remaining()) {
    file.fail_whole("holds no whole JSON chunk: it is damaged or truncated");
  }
  Document document;
  document.json = parse(file, file.take(json_size), json_size);
  if (file.remaining() < 8) return document;
  document.data_size = read_word(file);
  if (read_word(file) != kDataChunk || document.data_size > file.remaining()) {
    file.fail_whole("holds no whole data chunk: it is damaged or truncated");
  }
  return document;
}

/// Checks what one part of a glTF file says of another.
class GltfCheck {
 public:
  GltfCheck(const InputFile& file, const Document& document, bool binary)
      : file_(file), json_(document.json), data_size_(document.data_size), binary_(binary) {}

  GltfNode run() {
    for (const Json& view : list("bufferViews")) check_view(view);
    for (const Json& accessor : list("accessors")) check_accessor(accessor);
    for (const Json& mesh : list("meshes")) {
      for (const Json& primitive : member(mesh, "primitives")) check_primitive(primitive);
    }
    check_nodes();
    return shown_nodes();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    file_.fail_whole("is a damaged glTF file, export it again: " + what);
  }

  const Json& list(const char* name) const {
    static const Json kNone = Json::array();
    const auto found = json_.find(name);
    if (found == json_.end()) return kNone;
    if (!found->is_array()) fail(std::string("'") + name + "' is no list");
    return *found;
  }

  const Json& member(const Json& object, const char* name) const {
    if (!object.is_object() || !object.contains(name))
      fail(std::string("'") + name + "' is missing");
    return object[name];
  }

  /// A whole number from 0 to below 2^53; `standard` where it is missing.
  std::uint64_t number(const Json& object, const char* name, std::int64_t standard = -1) const {
    if (!object.is_object()) fail("an object is expected");
    const auto found = object.find(name);
    if (found == object.end() && standard >= 0) return static_cast<std::uint64_t>(standard);
    if (found == object.end() || !found->is_number_unsigned() ||
        found->get<std::uint64_t>() > (std::uint64_t{1} << 53)) {
      fail(in_quotes(name) + " must be a whole number");
    }
    return found->get<std::uint64_t>();
  }

  const Json& item(const char* name, std::uint64_t index) const {
    const Json& items = list(name);
    if (index >= items.size()) {
      fail(std::string(name) + " has no entry " + std::to_string(index));
    }
    return items[index];
  }

  void check_view(const Json& view) const {
    const std::uint64_t number_of_buffer = number(view, "buffer");
    const Json& buffer = item("buffers", number_of_buffer);
    const std::uint64_t size = number(buffer, "byteLength");
    if (binary_ && number_of_buffer == 0 && !buffer.contains("uri") && size > data_size_ + 3) {
      fail("its data are shorter than its buffer");
    }
    if (number(view, "byteOffset", 0) + number(view, "byteLength") > size) {
      fail("a view reaches beyond its buffer");
    }
  }

  static std::uint64_t component_size(std::uint64_t type) {
    switch (type) {
      case 5120:
      case 5121:
        return 1;
      case 5122:
      case 5123:
        return 2;
      case 5125:
      case 5126:
        return 4;
      default:
        return 0;
    }
  }

  static std::uint64_t component_count(const Json& type) {
    static const std::array<std::pair<const char*, int>, 7> kTypes = {{{"SCALAR", 1},
                                                                       {"VEC2", 2},
                                                                       {"VEC3", 3},
                                                                       {"VEC4", 4},
                                                                       {"MAT2", 4},
                                                                       {"MAT3", 9},
                                                                       {"MAT4", 16}}};
    for (const auto& [name, count] : kTypes) {
      if (type == name) return static_cast<std::uint64_t>(count);
    }
    return 0;
  }

  void check_accessor(const Json& accessor) const {
    const std::uint64_t element = component_size(number(accessor, "componentType")) *
                                  component_count(member(accessor, "type"));
    if (element == 0) fail("an accessor has an unknown type");
    const std::uint64_t count = number(accessor, "count");
    if (accessor.contains("sparse")) {
      file_.fail_whole("has sparse accessors, which brindle does not read; export it without");
    }
    if (count == 0 || count > 0xfffffffe) fail("an accessor has an impossible number of entries");
    // Without a view, as with compressed data, there is nothing to check here.
    if (!accessor.contains("bufferView")) return;
    const Json& view = item("bufferViews", number(accessor, "bufferView"));
    const std::uint64_t stride = std::max(number(view, "byteStride", 0), element);
    const std::uint64_t length = number(view, "byteLength");
    const std::uint64_t first_end = number(accessor, "byteOffset", 0) + element;
    // Divided, because the product of stride and count could wrap.
    if (first_end > length || (length - first_end) / stride < count - 1) {
      fail("an accessor reaches beyond its view");
    }
  }

  void check_primitive(const Json& primitive) const {
    const Json& attributes = member(primitive, "attributes");
    if (!attributes.is_object()) fail("'attributes' is no object");
    std::uint64_t vertices = 0;
    for (const auto& [name, value] : attributes.items()) {
      const std::uint64_t count =
          number(item("accessors", number(attributes, name.c_str())), "count");
      if (vertices != 0 && count != vertices) fail("attributes of different lengths");
      vertices = count;
    }
    if (attributes.contains("POSITION")) {
      const Json& position = item("accessors", number(attributes, "POSITION"));
      if (member(position, "type") != "VEC3" || number(position, "componentType") != 5126) {
        fail("positions must be vectors of three floats");
      }
    }
    if (primitive.contains("indices")) {
      const Json& indices = item("accessors", number(primitive, "indices"));
      const std::uint64_t type = number(indices, "componentType");
      if (member(indices, "type") != "SCALAR" || (type != 5121 && type != 5123 && type != 5125)) {
        fail("indices must be unsigned whole numbers");
      }
    }
  }

  /// Nodes must form trees: as many are reached from nodes without a parent as there are, each by
  /// one way.
  void check_nodes() const {
    const Json& nodes = list("nodes");
    std::vector<int> depth(nodes.size(), 0);
    std::vector<char> has_parent(nodes.size(), 0);
    for (const Json& node : nodes) {
      if (!node.is_object()) fail("a node is no object");
      if (node.contains("mesh")) item("meshes", number(node, "mesh"));
      for (const std::uint64_t child : children(node)) {
        if (child >= nodes.size()) fail("a node has a child that does not exist");
        if (has_parent[child]++) fail("a node has two parents");
      }
    }
    std::vector<std::uint64_t> open;
    for (std::uint64_t n = 0; n < nodes.size(); ++n) {
      if (!has_parent[n]) open.push_back(n);
    }
    std::size_t reached = 0;
    while (!open.empty()) {
      const std::uint64_t n = open.back();
      open.pop_back();
      ++reached;
      if (depth[n] > kDeepest) fail("its nodes are nested too deeply");
      for (const std::uint64_t child : children(nodes[n])) {
        depth[child] = depth[n] + 1;
        open.push_back(child);
      }
    }
    if (reached != nodes.size()) fail("its nodes run in a circle");
    check_scenes(nodes.size());
  }

  void check_scenes(std::size_t nodes) const {
    for (const Json& scene : list("scenes")) {
      if (!scene.is_object()) fail("a scene is no object");
      if (!scene.contains("nodes")) continue;
      for (const std::uint64_t node : indices(scene["nodes"])) {
        if (node >= nodes) fail("a scene has a node that does not exist");
      }
    }
    if (json_.contains("scene")) item("scenes", number(json_, "scene"));
  }

  GltfNode shown_nodes() const {
    const Json& scenes = list("scenes");
    const std::uint64_t shown = number(json_, "scene", 0);
    GltfNode all;
    if (shown >= scenes.size() || !scenes[shown].contains("nodes")) return all;
    for (const std::uint64_t root : indices(scenes[shown]["nodes"])) {
      all.children.push_back(tree(root));
    }
    return all.children.size() == 1 ? GltfNode(std::move(all.children[0])) : all;
  }

  GltfNode tree(std::uint64_t index) const {
    const Json& node = list("nodes")[index];
    GltfNode result;
    result.translation = translation(node);
    for (const std::uint64_t child : children(node)) result.children.push_back(tree(child));
    return result;
  }

  /// Zero if there is none.
  static Eigen::Vector3d translation(const Json& node) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    const bool matrix = node.contains("matrix");
    if (!matrix && !node.contains("translation")) return result;
    const Json& numbers = node[matrix ? "matrix" : "translation"];
    const std::size_t first = matrix ? 12 : 0;
    if (!numbers.is_array() || numbers.size() < first + 3) return result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Json& number = numbers[first + axis];
      if (number.is_number()) result[static_cast<Eigen::Index>(axis)] = number.get<double>();
    }
    return result;
  }

  std::vector<std::uint64_t> children(const Json& node) const {
    return node.contains("children") ? indices(node["children"]) : std::vector<std::uint64_t>();
  }

  std::vector<std::uint64_t> indices(const Json& values) const {
    if (!values.is_array()) fail("a list of numbers is expected");
    std::vector<std::uint64_t> result;
    for (const Json& value : values) {
      if (!value.is_number_unsigned()) fail("a list of whole numbers is expected");
      result.push_back(value.get<std::uint64_t>());
    }
    return result;
  }

  const InputFile& file_;
  const Json& json_;
  std::uint64_t data_size_;
  bool binary_;
};

/// One array of a file's buffer.
struct Block {
  std::string name;  ///< of the attribute; empty for indices and for pictures
  const void* data;
  std::uint64_t size;  ///< bytes
  std::uint64_t count;
  int components;
};

std::string gltf_name(const VertexAttribute& attribute) {
  if (attribute.is_normal()) return "NORMAL";
  if (attribute.is_color()) return "COLOR_0";
  if (attribute.is_uv()) return "TEXCOORD_0";
  std::string name = "_" + attribute.name;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

std::vector<Block> blocks_of(const Mesh& mesh, std::span<const VertexAttribute> attributes) {
  const std::uint64_t vertices = mesh.vertex_count(), corners = 3 * mesh.triangle_count();
  static_assert(sizeof(Vec3) == 12 && sizeof(Triangle) == 12);
  std::vector<Block> blocks = {{"", mesh.triangles.data(), 4 * corners, corners, 1},
                               {"POSITION", mesh.positions.data(), 12 * vertices, vertices, 3}};
  for (const VertexAttribute& a : attributes) {
    blocks.push_back({gltf_name(a), a.values.data(), 4 * a.values.size(), vertices, a.components});
  }
  return blocks;
}

/// Texture coordinates whose V runs down, as in glTF.
std::vector<VertexAttribute> with_v_down(std::span<const VertexAttribute> attributes) {
  std::vector<VertexAttribute> turned(attributes.begin(), attributes.end());
  for (VertexAttribute& attribute : turned) {
    if (!attribute.is_uv()) continue;
    for (std::size_t i = 1; i < attribute.values.size(); i += 2) {
      attribute.values[i] = 1 - attribute.values[i];
    }
  }
  return turned;
}

/// Adds a material that shows the picture, whose bytes follow the blocks, and gives it to the mesh.
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
  return components == 3 ? "VEC3" : components == 2 ? "VEC2" : "SCALAR";
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

void write_word(std::ostream& out, std::uint64_t word) {
  const auto narrow = static_cast<std::uint32_t>(word);
  out.write(reinterpret_cast<const char*>(&narrow), 4);
}

/// Base64 of several pieces of memory as if they were one.
class Base64 {
 public:
  explicit Base64(std::ostream& out) : out_(out) {}

  void put(const void* data, std::uint64_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::uint64_t i = 0; i < size; ++i) {
      group_ = group_ << 8 | bytes[i];
      if (++filled_ == 3) put_group(4);
    }
  }

  void finish() {
    if (filled_ > 0) {
      const int letters = filled_ + 1;
      group_ <<= 8 * (3 - filled_);
      put_group(letters);
      for (int i = letters; i < 4; ++i) out_.put('=');
    }
  }

 private:
  void put_group(int letters) {
    constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<char, 4> text{};
    for (int i = 0; i < 4; ++i) text[i] = kLetters[group_ >> (18 - 6 * i) & 63];
    out_.write(text.data(), letters);
    group_ = 0;
    filled_ = 0;
  }

  std::ostream& out_;
  std::uint32_t group_ = 0;
  int filled_ = 0;
};

void write_text(std::ostream& out, Json json, const std::vector<Block>& blocks) {
  constexpr std::string_view kMark = "@";
  json["buffers"][0]["uri"] = kMark;
  const std::string text = json.dump();
  const std::size_t mark = text.find("\"@\"") + 1;
  out << text.substr(0, mark) << "data:application/octet-stream;base64,";
  Base64 base64(out);
  for (const Block& block : blocks) base64.put(block.data, block.size);
  base64.finish();
  out << text.substr(mark + kMark.size()) << '\n';
}

void write_binary(std::ostream& out, const Json& json, const std::vector<Block>& blocks,
                  std::uint64_t size) {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  write_word(out, kMagic);
  write_word(out, 2);
  write_word(out, 12 + 8 + text.size() + 8 + size);
  write_word(out, text.size());
  write_word(out, kJsonChunk);
  out << text;
  write_word(out, size);
  write_word(out, kDataChunk);
  for (const Block& block : blocks) {
    out.write(static_cast<const char*>(block.data), static_cast<std::streamsize>(block.size));
  }
}

}  // namespace

GltfNode check_gltf(const std::filesystem::path& path) {
  InputFile file(path);
  const bool binary = lower_extension(path) != ".gltf";
  Document document;
  if (binary) {
    document = read_glb(file);
  } else {
    const auto size = static_cast<std::size_t>(file.remaining());
    document.json = parse(file, file.take(size), size);
  }
  return GltfCheck(file, document, binary).run();
}

void write_gltf(std::ostream& out, const Mesh& mesh, std::span<const VertexAttribute> attributes,
                GltfKind kind, const std::string& png) {
  if (mesh.triangles.empty()) {
    throw Error("glTF cannot hold a mesh without triangles; choose PLY or OBJ");
  }
  const std::vector<VertexAttribute> stored = with_v_down(attributes);
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

GltfNode check_gltf(const std::filesystem::path&) { refuse(); }

void write_gltf(std::ostream&, const Mesh&, std::span<const VertexAttribute>, GltfKind,
                const std::string&) {
  refuse();
}

}  // namespace brindle

#endif
