#include "brindle/files/gltf/gltf_reader.h"

#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"

#ifdef BRINDLE_HAS_JSON

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/files/gltf/gltf_buffers.h"
#include "brindle/files/gltf/gltf_document.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/piecewise_arrays.h"
#include "brindle/files/text/letters.h"

namespace brindle {
namespace {

using Json = nlohmann::json;
using Eigen::Affine3d;
using Eigen::Vector3d;

enum PrimitiveMode { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };
enum ComponentType { kUnsignedByte = 5121, kUnsignedShort = 5123 };

constexpr std::uint64_t kBytesOfPrimitive = 64;  ///< even of one that has nothing to show

/// Puts the meshes of a checked document together.
class GltfReader {
 public:
  GltfReader(std::filesystem::path path, const GltfDocument& document, const GltfBounds& bounds)
      : path_(std::move(path)), json_(document.json), buffers_(path_, document), bounds_(bounds) {}

  RawMesh read() {
    for (const std::uint64_t root : roots()) add_node(root, Affine3d::Identity());
    std::string left_out;
    DataArrays arrays{arrays_.take("vertices", left_out), {}};
    if (without_data_ > 0) {
      left_out += std::to_string(without_data_) +
                  " primitives: left out, because their positions or indices have no data\n";
    }
    RawMesh raw = builder_.take(std::move(arrays));
    raw.left_out = std::move(left_out);
    return raw;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(shown(path_.string()) + ": " + what);
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
    spend(kBytesOfPrimitive);
    if (!primitive["attributes"].contains("POSITION")) return;
    const std::uint64_t accessor = primitive["attributes"]["POSITION"].get<std::uint64_t>();
    const bool indexed = primitive.contains("indices");
    if (!has_data(accessor) || (indexed && !has_data(number(primitive, "indices", 0)))) {
      ++without_data_;  // all zeros, as the format says: no triangle has an area
      return;
    }
    const Index first = add_vertices(primitive["attributes"], transform);
    const auto count = static_cast<Index>(number(item("accessors", accessor), "count", 0));
    std::vector<Index> corners = corners_of(primitive, count);
    for (Index& corner : corners) corner += first;
    add_triangles(corners, static_cast<PrimitiveMode>(mode), transform.linear().determinant() < 0);
  }

  bool has_data(std::uint64_t accessor) const {
    return item("accessors", accessor).contains("bufferView");
  }

  /// Throws if a small file asks for so much memory in all.
  void spend(std::uint64_t bytes) {
    spent_ += bytes;
    if (spent_ <= bounds_.bytes + bounds_.repeats * buffers_.size()) return;
    fail("repeats its meshes and data until they have more than " +
         std::to_string(bounds_.bytes >> 20) + " MiB and " + std::to_string(bounds_.repeats) +
         " times its size; export it with fewer copies");
  }

  /// The same for what an accessor's data become, which it has read.
  void spend(std::uint64_t accessor, std::uint64_t bytes) {
    data_of(item("accessors", accessor));
    spend(bytes);
  }

  /// Attributes that become arrays. Positions are none, and those of bones move them.
  static bool is_array(std::string_view semantic) {
    return semantic != "POSITION" && !semantic.starts_with("JOINTS_") &&
           !semantic.starts_with("WEIGHTS_");
  }

  /// What primitives have in common that share their vertices: the accessors of all their
  /// attributes.
  using Attributes = std::vector<std::pair<std::string, std::uint64_t>>;

  static Attributes attributes_of(const Json& attributes) {
    Attributes result;
    for (const auto& [semantic, accessor] : attributes.items()) {
      if (semantic != "POSITION" && !is_array(semantic)) continue;
      result.emplace_back(semantic, accessor.get<std::uint64_t>());
    }
    return result;
  }

  /// The number of the first of a primitive's vertices.
  Index add_vertices(const Json& attributes, const Affine3d& transform) {
    const std::uint64_t accessor = number(attributes, "POSITION", 0);
    const auto [entry, is_new] = first_vertex_.try_emplace(
        attributes_of(attributes), static_cast<Index>(builder_.vertex_count()));
    if (!is_new) return entry->second;
    const Json& described = item("accessors", accessor);
    const std::uint64_t count = number(described, "count", 0);
    if (builder_.vertex_count() + count > 0xfffffffe) {
      fail("has more vertices than brindle can number; split it into parts");
    }
    spend(accessor, count * sizeof(Vector3d));
    const NumberType type = number_type(described);
    const double one = unit_of(described);
    with_number_type(type, [&]<class Number>(Number) {
      for_each_element(accessor, 3 * sizeof(Number), [&](const char* bytes) {
        Vector3d position = vector_at<Number>(bytes) / one;
        if (one > 1) position = position.cwiseMax(-1);  // the lowest number is a step beyond it
        builder_.add_vertex(transform * position);
      });
    });
    arrays_.add(arrays_of(attributes, transform.linear()));
    return entry->second;
  }

  template <class Number>
  static Vector3d vector_at(const char* bytes) {
    std::array<Number, 3> numbers{};
    std::memcpy(numbers.data(), bytes, sizeof numbers);
    return {static_cast<double>(numbers[0]), static_cast<double>(numbers[1]),
            static_cast<double>(numbers[2])};
  }

  /// What stands for 1 in an accessor: whole numbers may be parts of their largest.
  static double unit_of(const Json& accessor) {
    const auto normalized = accessor.find("normalized");
    const bool parts =
        normalized != accessor.end() && normalized->is_boolean() && normalized->get<bool>();
    return parts ? largest_of(number_type(accessor)) : 1;
  }

  static double largest_of(NumberType type) {
    double largest = 1;
    with_number_type(type, [&]<class Number>(Number) {
      if constexpr (std::is_integral_v<Number>) {
        largest = static_cast<double>(std::numeric_limits<Number>::max());
      }
    });
    return largest;
  }

  /// What a primitive says of its vertices.
  std::vector<DataArray> arrays_of(const Json& attributes, const Eigen::Matrix3d& linear) {
    std::vector<DataArray> arrays;
    for (const auto& [semantic, accessor] : attributes.items()) {
      if (!is_array(semantic)) continue;
      const Json& described = item("accessors", accessor.get<std::uint64_t>());
      DataArray array{array_name(semantic), number_type(described), components(described), {}};
      // Columns of smaller numbers are padded; nobody stores data like that. Nor are there any
      // without a view, but zeros.
      const bool padded = described["type"].get<std::string>().starts_with("MAT") &&
                          array.type != NumberType::float32;
      if (padded || !described.contains("bufferView")) continue;
      const std::size_t row = size_of(array.type) * static_cast<std::size_t>(array.components);
      spend(accessor.get<std::uint64_t>(), row * number(described, "count", 0));
      for_each_element(accessor.get<std::uint64_t>(), row, [&](const char* bytes) {
        const auto* begin = reinterpret_cast<const std::byte*>(bytes);
        array.bytes.insert(array.bytes.end(), begin, begin + row);
      });
      if (semantic.starts_with("TEXCOORD_"))
        array = with_v_up(array, unit_of_coordinates(described));
      const bool direction = semantic == "NORMAL" || semantic == "TANGENT";
      // Of a direction whole numbers are always parts of their largest.
      if (direction) array = as_floats(array, largest_of(array.type));
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

  /// Of texture coordinates whole numbers are parts of their largest, unless the file uses the
  /// extension that allows others.
  double unit_of_coordinates(const Json& accessor) const {
    const auto used = json_.find("extensionsUsed");
    const bool any = used != json_.end() && used->is_array() &&
                     ranges::find(*used, "KHR_mesh_quantization") != used->end();
    return any ? unit_of(accessor) : largest_of(number_type(accessor));
  }

  /// Numbers that are `one` as 1, and none below -1: the lowest whole number is a step beyond it.
  static DataArray as_floats(const DataArray& array, double one) {
    if (array.type == NumberType::float32) return array;
    std::vector<float> numbers;
    for_each_number(array.view(), [&](std::size_t, std::size_t, auto number) {
      numbers.push_back(static_cast<float>(std::max(-1.0, static_cast<double>(number) / one)));
    });
    return make_data_array(array.name, array.components, numbers);
  }

  /// Texture coordinates as floats whose V runs up; in glTF it runs down.
  static DataArray with_v_up(const DataArray& array, double one) {
    std::vector<float> numbers;
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
  std::vector<Index> corners_of(const Json& primitive, Index vertices) {
    std::vector<Index> corners;
    if (!primitive.contains("indices")) {
      spend(vertices * sizeof(Triangle));  // the positions' data have been read
      for (Index v = 0; v < vertices; ++v) corners.push_back(v);
      return corners;
    }
    const auto accessor = primitive["indices"].get<std::uint64_t>();
    const std::uint64_t type = number(item("accessors", accessor), "componentType", 0);
    const std::size_t size = type == kUnsignedByte ? 1 : type == kUnsignedShort ? 2 : 4;
    spend(accessor, number(item("accessors", accessor), "count", 0) * sizeof(Triangle));
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
  void for_each_element(std::uint64_t number_of_accessor, std::size_t size, const Use& use) {
    const Json& accessor = item("accessors", number_of_accessor);
    const std::uint64_t count = number(accessor, "count", 0);
    const std::string& data = data_of(accessor);
    const Json& view = item("bufferViews", number(accessor, "bufferView", 0));
    const std::uint64_t stride = std::max<std::uint64_t>(number(view, "byteStride", 0), size);
    const std::uint64_t begin = number(view, "byteOffset", 0) + number(accessor, "byteOffset", 0);
    for (std::uint64_t i = 0; i < count; ++i) use(data.data() + begin + i * stride);
  }

  /// The buffer in which an accessor's data stand.
  const std::string& data_of(const Json& accessor) {
    const Json& view = item("bufferViews", number(accessor, "bufferView", 0));
    if (view.contains("extensions") && view["extensions"].contains("EXT_meshopt_compression")) {
      fail("is compressed with meshopt, which brindle does not read; export it without");
    }
    return buffers_.buffer(number(view, "buffer", 0));
  }

  std::filesystem::path path_;
  const Json& json_;
  MeshBuilder builder_;
  PiecewiseArrays arrays_;
  GltfBuffers buffers_;
  GltfBounds bounds_;
  std::map<Attributes, Index> first_vertex_;  ///< of the node's primitives
  std::uint64_t spent_ = 0;                   ///< bytes of memory
  std::size_t without_data_ = 0;
};

}  // namespace

RawMesh read_gltf(const std::filesystem::path& path, const Progress& progress,
                  const GltfBounds& bounds) {
  const GltfDocument document = read_gltf_document(path, progress);
  try {
    return GltfReader(path, document, bounds).read();
  } catch (const Json::exception& error) {
    throw Error(shown(path.string()) +
                ": is a damaged glTF file, export it again: " + printable(error.what()));
  }
}

}  // namespace brindle

#else

namespace brindle {

RawMesh read_gltf(const std::filesystem::path& path, const Progress& /*progress*/,
                  const GltfBounds& /*bounds*/) {
  throw Error(shown(path.string()) +
              ": this brindle was built without nlohmann-json and so without glTF; choose PLY or "
              "OBJ");
}

}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
