#include "brindle/files/gltf/gltf_document.h"

#include "brindle/files.h"

#ifdef BRINDLE_HAS_JSON

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "brindle/base/base64.h"
#include "brindle/base/file_names.h"
#include "brindle/base/input_file.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files/text/text_words.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::json;

constexpr int kDeepest = 200;  ///< nesting of JSON and of nodes

std::uint32_t read_word(InputFile& file) {
  std::uint32_t word = 0;
  std::memcpy(&word, file.take(4), 4);
  return word;
}

/// The nesting depth of a JSON text. The parser's callback finds it too, but takes quadratic time
/// in a list's length.
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

[[noreturn]] void fail_version(const InputFile& file, const std::string& version) {
  file.fail_whole("is of glTF version " + printable(version, 20) +
                  ", and brindle reads version 2.0; convert it");
}

GltfDocument read_glb(InputFile& file) {
  const std::uint64_t size = file.remaining();
  if (read_word(file) != kGltfMagic)
    file.fail_whole("is not a GLB file: it does not begin with 'glTF'");
  if (const std::uint32_t version = read_word(file); version != 2) {
    fail_version(file, std::to_string(version));
  }
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

/// Reads the parts of a document and checks their references.
class GltfParts {
 public:
  GltfParts(const InputFile& file, GltfDocument& document, bool binary)
      : file_(file), document_(document), json_(document.json), binary_(binary) {}

  void read() {
    check_version();
    check_extensions();
    for (const Json& view : list("bufferViews")) document_.views.push_back(read_view(view));
    for (const Json& accessor : list("accessors")) {
      document_.accessors.push_back(read_accessor(accessor));
    }
    for (const Json& mesh : list("meshes")) {
      auto& primitives = document_.meshes.emplace_back();
      for (const Json& primitive : member(mesh, "primitives")) {
        primitives.push_back(read_primitive(primitive));
      }
    }
    read_nodes();
    for (const Json& skin : list("skins")) document_.skins.push_back(read_skin(skin));
    read_scenes();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    file_.fail_whole("is a damaged glTF file, export it again: " + what);
  }

  void check_version() const {
    const auto asset = json_.find("asset");
    if (asset == json_.end() || !asset->is_object()) return;
    const auto version = asset->find("version");
    if (version == asset->end() || !version->is_string()) return;
    const std::string& text = version->get_ref<const std::string&>();
    if (!text.starts_with("2.")) fail_version(file_, text);
  }

  /// Rejects extensions that may change the geometry in an unknown way.
  void check_extensions() const {
    constexpr std::array<std::string_view, 4> kRead = {
        "KHR_mesh_quantization", "EXT_mesh_gpu_instancing",
        // Rejected later, with a remedy, if a mesh uses them.
        "KHR_draco_mesh_compression", "EXT_meshopt_compression"};
    constexpr std::array<std::string_view, 8> kOfLooks = {
        "KHR_materials_", "EXT_materials_", "KHR_texture_", "EXT_texture_",
        "MSFT_texture_",  "KHR_lights_",    "EXT_lights_",  "KHR_xmp"};
    for (const Json& extension : list("extensionsRequired")) {
      if (!extension.is_string()) fail("'extensionsRequired' holds what is no text");
      const std::string& name = extension.get_ref<const std::string&>();
      const bool is_known =
          ranges::find(kRead, name) != kRead.end() ||
          ranges::any_of(kOfLooks, [&](auto prefix) { return name.starts_with(prefix); });
      if (is_known) continue;
      file_.fail_whole("requires the glTF extension " + in_quotes(name) +
                       ", which brindle does not read; export it without");
    }
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

  /// The index of an existing part of the list `of`.
  std::uint64_t number_of(const char* of, const Json& object, const char* name) const {
    const std::uint64_t index = number(object, name);
    if (index >= list(of).size()) {
      fail(std::string(of) + " has no entry " + std::to_string(index));
    }
    return index;
  }

  static bool has_extension(const Json& object, const char* name) {
    return object.contains("extensions") && object["extensions"].contains(name);
  }

  GltfView read_view(const Json& json) const {
    GltfView view;
    view.buffer = number_of("buffers", json, "buffer");
    const Json& buffer = json_["buffers"][view.buffer];
    const std::uint64_t size = number(buffer, "byteLength");
    if (binary_ && view.buffer == 0 && !buffer.contains("uri") &&
        size > document_.data.size() + 3) {
      fail("its data are shorter than its buffer");
    }
    view.offset = number(json, "byteOffset", 0);
    view.length = number(json, "byteLength");
    if (view.offset + view.length > size) fail("a view reaches beyond its buffer");
    view.is_compressed = has_extension(json, "EXT_meshopt_compression");
    return view;
  }

  GltfAccessor read_accessor(const Json& json) const {
    constexpr std::uint64_t kFirstType = 5120;
    constexpr std::array<NumberType, 7> kTypes = {
        NumberType::int8,  NumberType::uint8,  NumberType::int16,  NumberType::uint16,
        NumberType::int32, NumberType::uint32, NumberType::float32};
    static const std::map<std::string, int> kComponents = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3},
                                                           {"VEC4", 4},   {"MAT2", 4}, {"MAT3", 9},
                                                           {"MAT4", 16}};
    GltfAccessor accessor;
    const std::uint64_t type = number(json, "componentType") - kFirstType;
    const Json& shape = member(json, "type");
    const auto components =
        shape.is_string() ? kComponents.find(shape.get<std::string>()) : kComponents.end();
    // The format has no signed numbers of 32 bits.
    if (components == kComponents.end() || type >= kTypes.size() ||
        kTypes[type] == NumberType::int32) {
      fail("an accessor has an unknown type");
    }
    accessor.type = kTypes[type];
    accessor.components = components->second;
    accessor.is_matrix = components->first.starts_with("MAT");
    accessor.count = number(json, "count");
    if (accessor.count == 0 || accessor.count > 0xfffffffe) {
      fail("an accessor has an impossible number of entries");
    }
    const auto normalized = json.find("normalized");
    accessor.is_normalized = normalized != json.end() && *normalized == true;
    // Compressed data have no view, so there is nothing to check here.
    if (json.contains("bufferView")) place(json, accessor);
    if (json.contains("sparse")) accessor.sparse = read_sparse(json["sparse"], accessor);
    return accessor;
  }

  GltfSparse read_sparse(const Json& json, const GltfAccessor& accessor) const {
    GltfSparse sparse;
    sparse.count = number(json, "count");
    if (sparse.count == 0 || sparse.count > accessor.count) {
      fail("a sparse accessor has an impossible number of entries");
    }
    const Json &indices = member(json, "indices"), &values = member(json, "values");
    switch (number(indices, "componentType")) {
      case 5121:
        sparse.index_type = NumberType::uint8;
        break;
      case 5123:
        sparse.index_type = NumberType::uint16;
        break;
      case 5125:
        break;
      default:
        fail("indices of a sparse accessor must be unsigned whole numbers");
    }
    sparse.index_view = number_of("bufferViews", indices, "bufferView");
    sparse.index_offset = number(indices, "byteOffset", 0);
    check_room(sparse.index_view, sparse.index_offset, sparse.count, size_of(sparse.index_type));
    sparse.value_view = number_of("bufferViews", values, "bufferView");
    sparse.value_offset = number(values, "byteOffset", 0);
    check_room(sparse.value_view, sparse.value_offset, sparse.count, element_size(accessor));
    return sparse;
  }

  static std::uint64_t element_size(const GltfAccessor& accessor) {
    return size_of(accessor.type) * static_cast<std::uint64_t>(accessor.components);
  }

  void check_room(std::uint64_t number, std::uint64_t offset, std::uint64_t count,
                  std::uint64_t element) const {
    const GltfView& view = document_.views[number];
    if (offset > view.length || count > (view.length - offset) / element) {
      fail("a sparse accessor reaches beyond its view");
    }
  }

  /// Reads the position of the numbers in their view.
  void place(const Json& json, GltfAccessor& accessor) const {
    accessor.view = number_of("bufferViews", json, "bufferView");
    GltfView& view = document_.views[*accessor.view];
    const std::uint64_t element = element_size(accessor);
    view.stride = number(json_["bufferViews"][*accessor.view], "byteStride", 0);
    accessor.offset = number(json, "byteOffset", 0);
    const std::uint64_t stride = std::max(view.stride, element);
    const std::uint64_t first_end = accessor.offset + element;
    // Divided, because the product of stride and count could wrap.
    if (first_end > view.length || (view.length - first_end) / stride < accessor.count - 1) {
      fail("an accessor reaches beyond its view");
    }
  }

  GltfPrimitive read_primitive(const Json& json) const {
    GltfPrimitive primitive;
    const Json& attributes = member(json, "attributes");
    if (!attributes.is_object()) fail("'attributes' is no object");
    std::uint64_t vertices = 0;
    for (const auto& [name, value] : attributes.items()) {
      const std::uint64_t index = number_of("accessors", attributes, name.c_str());
      const std::uint64_t count = document_.accessors[index].count;
      if (vertices != 0 && count != vertices) fail("attributes of different lengths");
      vertices = count;
      primitive.attributes.emplace(name, index);
    }
    if (const auto position = primitive.attributes.find("POSITION");
        position != primitive.attributes.end()) {
      const GltfAccessor& accessor = document_.accessors[position->second];
      // 8-bit and 16-bit integers too: KHR_mesh_quantization.
      if (accessor.components != 3 || accessor.type == NumberType::uint32) {
        fail("positions must be vectors of three floats, or of whole numbers of 8 or 16 bits");
      }
    }
    primitive.mode = number(json, "mode", 4);
    if (json.contains("indices")) {
      primitive.indices = number_of("accessors", json, "indices");
      const GltfAccessor& accessor = document_.accessors[*primitive.indices];
      const bool is_unsigned = accessor.type == NumberType::uint8 ||
                               accessor.type == NumberType::uint16 ||
                               accessor.type == NumberType::uint32;
      if (accessor.components != 1 || !is_unsigned) fail("indices must be unsigned whole numbers");
    }
    primitive.is_compressed = has_extension(json, "KHR_draco_mesh_compression");
    primitive.has_targets = json.contains("targets");
    return primitive;
  }

  /// Nodes must form trees: each is reachable from the nodes without a parent, by exactly one path.
  void read_nodes() {
    const Json& nodes = list("nodes");
    std::vector<char> has_parent(nodes.size(), 0);
    for (const Json& json : nodes) {
      if (!json.is_object()) fail("a node is no object");
      GltfNode& node = document_.nodes.emplace_back();
      node.json = &json;
      if (json.contains("mesh")) node.mesh = number_of("meshes", json, "mesh");
      if (json.contains("skin")) node.skin = number_of("skins", json, "skin");
      if (has_extension(json, "EXT_mesh_gpu_instancing")) {
        node.instances = read_instances(json["extensions"]["EXT_mesh_gpu_instancing"]);
      }
      if (json.contains("children")) node.children = indices(json["children"]);
      for (const std::uint64_t child : node.children) {
        if (child >= nodes.size()) fail("a node has a child that does not exist");
        if (has_parent[child]++) fail("a node has two parents");
      }
    }
    for (std::uint64_t n = 0; n < nodes.size(); ++n) {
      if (!has_parent[n]) document_.tops.push_back(n);
    }
    document_.roots = document_.tops;
    check_depth();
  }

  std::map<std::string, std::uint64_t> read_instances(const Json& json) const {
    static const std::map<std::string, int> kComponents = {
        {"TRANSLATION", 3}, {"ROTATION", 4}, {"SCALE", 3}};
    const Json& attributes = member(json, "attributes");
    if (!attributes.is_object()) fail("'attributes' is no object");
    std::map<std::string, std::uint64_t> instances;
    std::uint64_t count = 0;
    for (const auto& [name, components] : kComponents) {
      if (!attributes.contains(name)) continue;
      const std::uint64_t index = number_of("accessors", attributes, name.c_str());
      const GltfAccessor& accessor = document_.accessors[index];
      if (accessor.components != components || (count != 0 && accessor.count != count)) {
        fail("the instances of a mesh have attributes of different lengths or unknown types");
      }
      count = accessor.count;
      instances.emplace(name, index);
    }
    return instances;
  }

  GltfSkin read_skin(const Json& json) const {
    GltfSkin skin;
    skin.joints = indices(member(json, "joints"));
    for (const std::uint64_t joint : skin.joints) {
      if (joint >= document_.nodes.size()) fail("a skin has a joint that does not exist");
    }
    if (!json.contains("inverseBindMatrices")) return skin;
    skin.inverse_bind_matrices = number_of("accessors", json, "inverseBindMatrices");
    const GltfAccessor& matrices = document_.accessors[*skin.inverse_bind_matrices];
    if (matrices.components != 16 || matrices.type != NumberType::float32 ||
        matrices.count < skin.joints.size()) {
      fail("a skin needs a matrix of 16 floats for each joint");
    }
    return skin;
  }

  void check_depth() const {
    std::vector<int> depth(document_.nodes.size(), 0);
    std::vector<std::uint64_t> open = document_.roots;
    std::size_t reached = 0;
    while (!open.empty()) {
      const std::uint64_t n = open.back();
      open.pop_back();
      ++reached;
      if (depth[n] > kDeepest) fail("its nodes are nested too deeply");
      for (const std::uint64_t child : document_.nodes[n].children) {
        depth[child] = depth[n] + 1;
        open.push_back(child);
      }
    }
    if (reached != document_.nodes.size()) fail("its nodes run in a circle");
  }

  void read_scenes() {
    std::vector<std::vector<std::uint64_t>> scenes;
    for (const Json& scene : list("scenes")) {
      if (!scene.is_object()) fail("a scene is no object");
      scenes.push_back(scene.contains("nodes") ? indices(scene["nodes"])
                                               : std::vector<std::uint64_t>());
      for (const std::uint64_t node : scenes.back()) {
        if (node >= document_.nodes.size()) fail("a scene has a node that does not exist");
      }
    }
    const std::uint64_t shown = json_.contains("scene") ? number_of("scenes", json_, "scene") : 0;
    if (!scenes.empty()) document_.roots = std::move(scenes[shown]);
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
  GltfDocument& document_;
  const Json& json_;
  bool binary_;
};

constexpr std::string_view kDataUri = "data:";

/// The file in the folder of the .gltf that a URI without data names; empty if the path leaves the
/// folder.
std::optional<fs::path> file_in_folder(const fs::path& gltf, const std::string& uri) {
  const std::string name = percent_decoded(uri);
  if (name.find('\0') != std::string::npos || name.find("://") != std::string::npos) {
    return std::nullopt;
  }
  const fs::path inside = fs::path(name).lexically_normal();
  if (inside.is_absolute() || inside.empty() || *inside.begin() == "..") return std::nullopt;
  return gltf.parent_path() / inside;
}

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
  GltfParts(file, document, binary).read();
  return document;
}

std::vector<fs::path> gltf_buffer_files(const fs::path& gltf) {
  std::vector<fs::path> paths;
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(whole_input(gltf, "a mesh file"), nullptr, false);
  } catch (const Error&) {
    return paths;
  }
  if (!json.is_object() || !json.contains("buffers") || !json["buffers"].is_array()) return paths;
  for (const auto& buffer : json["buffers"]) {
    if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
    const std::string uri = buffer["uri"];
    if (uri.starts_with(kDataUri)) continue;
    if (auto file = file_in_folder(gltf, uri)) paths.push_back(*std::move(file));
  }
  return paths;
}

void GltfBuffers::fail(const std::string& what) const {
  throw Error(shown(path_.string()) + ": " + what);
}

const std::string& GltfBuffers::buffer(std::uint64_t index) {
  const nlohmann::json& described = document_.json["buffers"][index];
  const std::string& content = content_of(described);
  const auto promised = described["byteLength"].get<std::uint64_t>();
  if (content.size() < promised) {
    fail("is truncated: a buffer has " + std::to_string(content.size()) + " bytes instead of " +
         std::to_string(promised) + "; export it again");
  }
  return content;
}

const std::string& GltfBuffers::content_of(const nlohmann::json& buffer) {
  const auto uri = buffer.find("uri");
  if (uri != buffer.end()) {
    if (!uri->is_string()) fail("is a damaged glTF file, export it again: 'uri' is no text");
    return content_of_uri(uri->get_ref<const std::string&>());
  }
  const auto [entry, is_new] = contents_.try_emplace("");
  if (is_new) {
    // A GLB's own buffer may lack the padding that its length includes.
    entry->second = document_.data + std::string(3, '\0');
    size_ += entry->second.size();
  }
  return entry->second;
}

const std::string& GltfBuffers::content_of_uri(const std::string& uri) {
  const auto [entry, is_new] = contents_.try_emplace(uri);
  std::string& content = entry->second;
  if (!is_new) return content;
  if (uri.starts_with(kDataUri)) {
    const std::size_t comma = uri.find(',');
    const bool base64 = comma != std::string::npos && uri.substr(0, comma).ends_with(";base64");
    auto bytes = base64 ? base64_decoded(std::string_view(uri).substr(comma + 1)) : std::nullopt;
    if (!bytes) fail("is a damaged glTF file, export it again: its data are not in base64");
    content = *std::move(bytes);
  } else {
    const std::optional<fs::path> file = file_in_folder(path_, uri);
    if (!file) {
      fail("names the data file " + in_quotes(uri) +
           ", which is not in its own folder, so brindle does not read it; put both into one "
           "folder and name it without a path");
    }
    try {
      content = whole_input(*file, "its data");
    } catch (const Error& error) {
      fail(std::string("needs a data file beside it: ") + error.what());
    }
  }
  size_ += content.size();
  return content;
}

}  // namespace brindle

#else

namespace brindle {

std::vector<std::filesystem::path> gltf_buffer_files(const std::filesystem::path&) { return {}; }

}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
