#include "brindle/files/gltf_reader.h"

#include "brindle/error.h"

#ifdef BRINDLE_HAS_JSON

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/base/printable.h"
#include "brindle/files/base64.h"
#include "brindle/files/gltf_document.h"
#include "brindle/files/letters.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/percent_decoded.h"
#include "brindle/files/piecewise_arrays.h"

namespace brindle {
namespace {

using Json = nlohmann::json;
using Eigen::Affine3d;
using Eigen::Vector3d;

enum PrimitiveMode { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };
enum ComponentType { kUnsignedByte = 5121, kUnsignedShort = 5123 };

/// Puts the meshes of a checked document together.
class GltfReader {
 public:
  GltfReader(std::filesystem::path path, const GltfDocument& document)
      : path_(std::move(path)), document_(document), json_(document.json) {}

  RawMesh read() {
    for (const std::uint64_t root : roots()) add_node(root, Affine3d::Identity());
    std::string left_out;
    DataArrays arrays{arrays_.take("vertices", left_out), {}};
    RawMesh raw = builder_.take(std::move(arrays));
    raw.left_out = std::move(left_out);
    return raw;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(path_.string() + ": " + what);
  }

  const Json& item(const char* list, std::uint64_t index) const { return json_[list][index]; }

  static std::uint64_t number(const Json& object, const char* name, std::uint64_t standard) {
    const auto found = object.find(name);
    return found == object.end() ? standard : found->get<std::uint64_t>();
  }

  /// The nodes of the default scene; of a file without scenes, all nodes without a parent.
  std::vector<std::uint64_t> roots() const {
    if (json_.contains("scenes") && !json_["scenes"].empty()) {
      const Json& scene = item("scenes", number(json_, "scene", 0));
      return scene.value("nodes", std::vector<std::uint64_t>());
    }
    if (!json_.contains("nodes")) return {};
    std::vector<char> has_parent(json_["nodes"].size(), 0);
    for (const Json& node : json_["nodes"]) {
      for (const std::uint64_t child : node.value("children", std::vector<std::uint64_t>())) {
        has_parent[child] = 1;
      }
    }
    std::vector<std::uint64_t> result;
    for (std::uint64_t n = 0; n < has_parent.size(); ++n) {
      if (!has_parent[n]) result.push_back(n);
    }
    return result;
  }

  /// A list of so many numbers; nothing if there is none of that name.
  std::optional<std::vector<double>> numbers(const Json& node, const char* name,
                                             std::size_t count) const {
    const auto found = node.find(name);
    if (found == node.end()) return std::nullopt;
    std::vector<double> values;
    if (found->is_array()) {
      for (const Json& value : *found) {
        if (value.is_number()) values.push_back(value.get<double>());
      }
    }
    if (values.size() == count && found->size() == count) return values;
    fail("is a damaged glTF file, export it again: a node's '" + std::string(name) + "' must be " +
         std::to_string(count) + " numbers");
  }

  Affine3d transform_of(const Json& node) const {
    Affine3d transform = Affine3d::Identity();
    if (const auto matrix = numbers(node, "matrix", 16)) {
      transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix->data());
      return transform;
    }
    if (const auto t = numbers(node, "translation", 3)) {
      transform.translate(Vector3d((*t)[0], (*t)[1], (*t)[2]));
    }
    if (const auto r = numbers(node, "rotation", 4)) {
      transform.rotate(Eigen::Quaterniond((*r)[3], (*r)[0], (*r)[1], (*r)[2]).normalized());
    }
    if (const auto s = numbers(node, "scale", 3)) {
      transform.scale(Vector3d((*s)[0], (*s)[1], (*s)[2]));
    }
    return transform;
  }

  void add_node(std::uint64_t number_of_node, const Affine3d& parent) {
    const Json& node = item("nodes", number_of_node);
    const Affine3d transform = parent * transform_of(node);
    if (node.contains("mesh")) {
      first_vertex_.clear();
      for (const Json& primitive : item("meshes", number(node, "mesh", 0))["primitives"]) {
        add_primitive(primitive, transform);
      }
    }
    for (const std::uint64_t child : node.value("children", std::vector<std::uint64_t>())) {
      add_node(child, transform);
    }
  }

  void add_primitive(const Json& primitive, const Affine3d& transform) {
    const std::uint64_t mode = number(primitive, "mode", kTriangles);
    if (mode < kTriangles || mode > kTriangleFan) return;  // points and lines
    if (primitive.contains("extensions") &&
        primitive["extensions"].contains("KHR_draco_mesh_compression")) {
      fail("is compressed with Draco, which brindle does not read; export it without compression");
    }
    if (!primitive["attributes"].contains("POSITION")) return;
    const std::uint64_t accessor = primitive["attributes"]["POSITION"].get<std::uint64_t>();
    const Index first = add_vertices(primitive["attributes"], transform);
    const auto count = static_cast<Index>(number(item("accessors", accessor), "count", 0));
    std::vector<Index> corners = corners_of(primitive, count);
    for (Index& corner : corners) corner += first;
    add_triangles(corners, static_cast<PrimitiveMode>(mode), transform.linear().determinant() < 0);
  }

  /// The number of the first of a primitive's vertices.
  Index add_vertices(const Json& attributes, const Affine3d& transform) {
    const std::uint64_t accessor = number(attributes, "POSITION", 0);
    const auto [entry, is_new] =
        first_vertex_.try_emplace(accessor, static_cast<Index>(builder_.vertex_count()));
    if (!is_new) return entry->second;
    const std::uint64_t count = number(item("accessors", accessor), "count", 0);
    if (builder_.vertex_count() + count > 0xfffffffe) {
      fail("has more vertices than brindle can number; split it into parts");
    }
    for_each_element(accessor, 12, [&](const char* bytes) {
      Eigen::Vector3f position;
      std::memcpy(position.data(), bytes, 12);
      builder_.add_vertex(transform * position.cast<double>());
    });
    arrays_.add(arrays_of(attributes, transform.linear()));
    return entry->second;
  }

  /// What a primitive says of its vertices.
  std::vector<DataArray> arrays_of(const Json& attributes, const Eigen::Matrix3d& linear) const {
    std::vector<DataArray> arrays;
    for (const auto& [semantic, accessor] : attributes.items()) {
      // Positions are no array, and those of bones move them.
      const bool other = semantic == "POSITION" || semantic.starts_with("JOINTS_") ||
                         semantic.starts_with("WEIGHTS_");
      if (other) continue;
      const Json& described = item("accessors", accessor.get<std::uint64_t>());
      DataArray array{array_name(semantic), number_type(described), components(described), {}};
      // Columns of smaller numbers are padded; nobody stores data like that. Nor are there any
      // without a view, but zeros.
      const bool padded = described["type"].get<std::string>().starts_with("MAT") &&
                          array.type != NumberType::float32;
      if (padded || !described.contains("bufferView")) continue;
      const std::size_t row = size_of(array.type) * static_cast<std::size_t>(array.components);
      for_each_element(accessor.get<std::uint64_t>(), row, [&](const char* bytes) {
        const auto* begin = reinterpret_cast<const std::byte*>(bytes);
        array.bytes.insert(array.bytes.end(), begin, begin + row);
      });
      if (semantic.starts_with("TEXCOORD_")) array = with_v_up(array);
      if (semantic == "NORMAL") turn(array, linear.inverse().transpose());
      if (semantic == "TANGENT") turn(array, linear);
      arrays.push_back(std::move(array));
    }
    return arrays;
  }

  /// "normal", "uv", "uv_1" or, of "_SPEED", "speed": capitals are what the format suggests.
  static std::string array_name(const std::string& semantic) {
    const auto numbered = [&](const std::string& prefix, const std::string& name) {
      const std::string number = semantic.substr(prefix.size());
      return number == "0" ? name : name + '_' + number;
    };
    if (semantic.starts_with("TEXCOORD_")) return numbered("TEXCOORD_", "uv");
    if (semantic.starts_with("COLOR_")) return numbered("COLOR_", "color");
    const bool small = std::any_of(semantic.begin(), semantic.end(),
                                   [](unsigned char c) { return std::islower(c); });
    const std::string name = semantic.substr(semantic.starts_with('_') ? 1 : 0);
    return small ? name : small_letters(name);
  }

  static NumberType number_type(const Json& accessor) {
    constexpr std::uint64_t kFirst = 5120;
    constexpr std::array<NumberType, 7> kTypes = {
        NumberType::int8,  NumberType::uint8,  NumberType::int16,  NumberType::uint16,
        NumberType::int32, NumberType::uint32, NumberType::float32};
    return kTypes.at(number(accessor, "componentType", 0) - kFirst);
  }

  static int components(const Json& accessor) {
    const auto type = accessor["type"].get<std::string>();
    if (type == "SCALAR") return 1;
    const int sides = type.back() - '0';
    return type.starts_with("MAT") ? sides * sides : sides;
  }

  /// Texture coordinates as floats whose V runs up; in glTF it runs down.
  static DataArray with_v_up(const DataArray& array) {
    std::vector<float> numbers;
    const double one = array.type == NumberType::uint8    ? 255
                       : array.type == NumberType::uint16 ? 65535
                                                          : 1;
    for_each_number(array.view(), [&](std::size_t, std::size_t column, auto number) {
      const auto value = static_cast<float>(static_cast<double>(number) / one);
      numbers.push_back(column == 1 ? 1 - value : value);
    });
    return make_data_array(array.name, array.components, numbers);
  }

  /// Turns the vectors of an array to where a node puts them.
  static void turn(DataArray& array, const Eigen::Matrix3d& linear) {
    const bool vectors = array.type == NumberType::float32 && array.components >= 3;
    if (!vectors || linear.isIdentity(0)) return;
    const std::size_t row = sizeof(float) * static_cast<std::size_t>(array.components);
    for (std::size_t at = 0; at < array.bytes.size(); at += row) {
      Vec3 vector;
      std::memcpy(vector.data(), &array.bytes[at], sizeof vector);
      vector = (linear * vector.cast<double>()).stableNormalized().cast<float>();
      std::memcpy(&array.bytes[at], vector.data(), sizeof vector);
    }
  }

  /// The vertices of a primitive in the order in which it names them, counted from its first.
  std::vector<Index> corners_of(const Json& primitive, Index vertices) const {
    std::vector<Index> corners;
    if (!primitive.contains("indices")) {
      for (Index v = 0; v < vertices; ++v) corners.push_back(v);
      return corners;
    }
    const auto accessor = primitive["indices"].get<std::uint64_t>();
    const std::uint64_t type = number(item("accessors", accessor), "componentType", 0);
    const std::size_t size = type == kUnsignedByte ? 1 : type == kUnsignedShort ? 2 : 4;
    for_each_element(accessor, size, [&](const char* bytes) {
      std::uint32_t corner = 0;  // little endian, as the format is
      std::memcpy(&corner, bytes, size);
      if (corner >= vertices) {
        fail(
            "is a damaged glTF file, export it again: a triangle has a corner that does not "
            "exist");
      }
      corners.push_back(corner);
    });
    return corners;
  }

  void add_triangles(const std::vector<Index>& corners, PrimitiveMode mode, bool mirrored) {
    const std::size_t step = mode == kTriangles ? 3 : 1;
    for (std::size_t c = 0; c + 2 < corners.size(); c += step) {
      Triangle triangle = {corners[c], corners[c + 1], corners[c + 2]};
      if (mode == kTriangleFan) triangle[0] = corners[0];
      // A mirroring transform turns triangles inside out, and so does every second one of a strip.
      const bool odd = mode == kTriangleStrip && c % 2 == 1;
      if (odd != mirrored) std::swap(triangle[1], triangle[2]);
      builder_.add_polygon(triangle);
    }
  }

  /// Calls `use` with the first byte of every element, which is `size` bytes long.
  template <class Use>
  void for_each_element(std::uint64_t number_of_accessor, std::size_t size, const Use& use) const {
    const Json& accessor = item("accessors", number_of_accessor);
    const std::uint64_t count = number(accessor, "count", 0);
    if (!accessor.contains("bufferView")) {
      const std::string zeros(size, '\0');  // as the format says
      for (std::uint64_t i = 0; i < count; ++i) use(zeros.data());
      return;
    }
    const Json& view = item("bufferViews", number(accessor, "bufferView", 0));
    if (view.contains("extensions") && view["extensions"].contains("EXT_meshopt_compression")) {
      fail("is compressed with meshopt, which brindle does not read; export it without");
    }
    const std::string& data = buffer(number(view, "buffer", 0));
    const std::uint64_t stride = std::max<std::uint64_t>(number(view, "byteStride", 0), size);
    const std::uint64_t begin = number(view, "byteOffset", 0) + number(accessor, "byteOffset", 0);
    for (std::uint64_t i = 0; i < count; ++i) use(data.data() + begin + i * stride);
  }

  /// A buffer's bytes, at least as many as it promises.
  const std::string& buffer(std::uint64_t index) const {
    const auto [entry, is_new] = buffers_.try_emplace(index);
    if (is_new) {
      const Json& buffer = item("buffers", index);
      entry->second = content_of(buffer);
      const std::uint64_t promised = number(buffer, "byteLength", 0);
      // A GLB's own buffer may lack its padding.
      if (entry->second.size() + 3 < promised) {
        fail("is truncated: a buffer has " + std::to_string(entry->second.size()) +
             " bytes instead of " + std::to_string(promised) + "; export it again");
      }
      entry->second.resize(std::max<std::size_t>(entry->second.size(), promised));
    }
    return entry->second;
  }

  std::string content_of(const Json& buffer) const {
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) return document_.data;
    if (!uri->is_string()) fail("is a damaged glTF file, export it again: 'uri' is no text");
    const auto& text = uri->get_ref<const std::string&>();
    if (!text.starts_with("data:")) return content_of_file(text);
    const std::size_t comma = text.find(',');
    const bool base64 = comma != std::string::npos && text.substr(0, comma).ends_with(";base64");
    auto bytes = base64 ? base64_decoded(std::string_view(text).substr(comma + 1)) : std::nullopt;
    if (!bytes) fail("is a damaged glTF file, export it again: its data are not in base64");
    return *std::move(bytes);
  }

  std::string content_of_file(const std::string& uri) const {
    const std::filesystem::path path = path_.parent_path() / percent_decoded(uri);
    std::error_code ignored;
    std::ifstream stream(path, std::ios::binary);
    if (!std::filesystem::is_regular_file(path, ignored) || !stream) {
      fail("needs the file " + in_quotes(path.string()) +
           ", which is not there or cannot be read; keep both in one folder");
    }
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::filesystem::path path_;
  const GltfDocument& document_;
  const Json& json_;
  MeshBuilder builder_;
  PiecewiseArrays arrays_;
  std::map<std::uint64_t, Index> first_vertex_;  ///< of the node's accessors of positions
  mutable std::map<std::uint64_t, std::string> buffers_;
};

}  // namespace

RawMesh read_gltf(const std::filesystem::path& path, const Progress& progress) {
  const GltfDocument document = read_gltf_document(path, progress);
  try {
    return GltfReader(path, document).read();
  } catch (const Json::exception& error) {
    throw Error(path.string() +
                ": is a damaged glTF file, export it again: " + printable(error.what()));
  }
}

}  // namespace brindle

#else

namespace brindle {

RawMesh read_gltf(const std::filesystem::path& path, const Progress& /*progress*/) {
  throw Error(path.string() +
              ": this brindle was built without nlohmann-json and so without glTF; choose PLY or "
              "OBJ");
}

}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
