#include "brindle/files/gltf/gltf_document.h"

#ifdef BRINDLE_HAS_JSON

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/input_file.h"
#include "brindle/base/text.h"

namespace brindle {
namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 200;  ///< nesting of JSON and of nodes

std::uint32_t read_word(InputFile& file) {
  std::uint32_t word = 0;
  std::memcpy(&word, file.take(4), 4);
  return word;
}

/// How deep a JSON text is nested. A parser with a callback would know, too, but takes a time that
/// grows with the square of a list's length.
int depth_of(std::string_view json) {
  int depth = 0, deepest = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text) {
      if (c == '\\') ++i;
      in_text = c != '"';
    } else if (c == '"') {
      in_text = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return deepest;
}

Json parse(const InputFile& file, const char* text, std::size_t size) {
  if (depth_of({text, size}) > kDeepest) file.fail_whole("is nested too deeply for a glTF file");
  try {
    Json json = Json::parse(text, text + size);
    if (!json.is_object()) file.fail_whole("is not a glTF file: its JSON is no object");
    return json;
  } catch (const Json::exception& error) {
    file.fail_whole("holds damaged or truncated JSON, export it again: " + printable(error.what()));
  }
}

GltfDocument read_glb(InputFile& file) {
  const std::uint64_t size = file.remaining();
  if (read_word(file) != kGltfMagic)
    file.fail_whole("is not a GLB file: it does not begin with 'glTF'");
  if (read_word(file) != 2) file.fail_whole("is not of glTF version 2; convert it");
  if (read_word(file) > size) {
    file.fail_whole("is shorter than its header says: it is truncated; copy or export it again");
  }
  const std::uint32_t json_size = read_word(file);
  if (read_word(file) != kGltfJsonChunk || json_size > file.remaining()) {
    file.fail_whole("holds no whole JSON chunk: it is damaged or truncated");
  }
  GltfDocument document;
  document.json = parse(file, file.take(json_size), json_size);
  if (file.remaining() < 8) return document;
  const std::uint32_t data_size = read_word(file);
  if (read_word(file) != kGltfDataChunk || data_size > file.remaining()) {
    file.fail_whole("holds no whole data chunk: it is damaged or truncated");
  }
  document.data.assign(file.take(data_size), data_size);
  return document;
}

/// Checks what one part of a glTF file says of another.
class GltfCheck {
 public:
  GltfCheck(const InputFile& file, const GltfDocument& document, bool binary)
      : file_(file), json_(document.json), data_size_(document.data.size()), binary_(binary) {}

  void run() {
    for (const Json& view : list("bufferViews")) check_view(view);
    for (const Json& accessor : list("accessors")) check_accessor(accessor);
    for (const Json& mesh : list("meshes")) {
      for (const Json& primitive : member(mesh, "primitives")) check_primitive(primitive);
    }
    check_nodes();
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
      // Whole numbers of 8 and 16 bits, too: KHR_mesh_quantization.
      const std::uint64_t type = number(position, "componentType");
      if (member(position, "type") != "VEC3" || type == 5125) {
        fail("positions must be vectors of three floats, or of whole numbers of 8 or 16 bits");
      }
    }
    number(primitive, "mode", 4);
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

}  // namespace

GltfDocument read_gltf_document(const std::filesystem::path& path, const Progress& progress) {
  InputFile file(path, progress);
  const bool binary = lower_extension(path) != ".gltf";
  GltfDocument document;
  if (binary) {
    document = read_glb(file);
  } else {
    const auto size = static_cast<std::size_t>(file.remaining());
    document.json = parse(file, file.take(size), size);
  }
  GltfCheck(file, document, binary).run();
  return document;
}

}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
