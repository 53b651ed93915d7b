#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files/gltf/gltf_file.h"

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
#include "brindle/files/gltf/gltf_document.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/read_arrays.h"
#include "brindle/files/text/text_words.h"

namespace brindle {
namespace {

using Json = nlohmann::json;
using Eigen::Affine3d;
using Eigen::Vector3d;

enum PrimitiveMode { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };

constexpr std::uint64_t kBytesOfPrimitive = 64;  ///< even of one without triangles

/// Joins the meshes of a document.
class GltfReader {
 public:
  GltfReader(std::filesystem::path path, const GltfDocument& document, const GltfBounds& bounds)
      : path_(std::move(path)), document_(document), buffers_(path_, document), bounds_(bounds) {}

  RawMesh read() {
    for (const std::uint64_t root : document_.roots) add_node(root, Affine3d::Identity());
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

  /// A node's list of `count` numbers; nothing if it has none of that name.
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

  void add_node(std::uint64_t number, const Affine3d& parent) {
    const GltfNode& node = document_.nodes[number];
    const Affine3d transform = parent * transform_of(*node.json);
    if (node.mesh) {
      first_vertex_.clear();
      for (const GltfPrimitive& primitive : document_.meshes[*node.mesh]) {
        add_primitive(primitive, transform);
      }
    }
    for (const std::uint64_t child : node.children) add_node(child, transform);
  }

  void add_primitive(const GltfPrimitive& primitive, const Affine3d& transform) {
    if (primitive.mode < kTriangles || primitive.mode > kTriangleFan) return;  // points and lines
    if (primitive.is_compressed) {
      fail("is compressed with Draco, which brindle does not read; export it without compression");
    }
    spend(kBytesOfPrimitive);
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return;
    const GltfAccessor& positions = document_.accessors[position->second];
    if (!positions.view || (primitive.indices && !document_.accessors[*primitive.indices].view)) {
      ++without_data_;  // all zeros, as the format says: no triangle has an area
      return;
    }
    const Index first = add_vertices(primitive, positions, transform);
    std::vector<Index> corners = corners_of(primitive, static_cast<Index>(positions.count));
    for (Index& corner : corners) corner += first;
    add_triangles(corners, static_cast<PrimitiveMode>(primitive.mode),
                  transform.linear().determinant() < 0);
  }

  /// Throws if a small file asks for so much memory in all.
  void spend(std::uint64_t bytes) {
    spent_ += bytes;
    if (spent_ <= bounds_.bytes + bounds_.repeats * buffers_.size()) return;
    fail("repeats its meshes and data until they have more than " +
         std::to_string(bounds_.bytes >> 20) + " MiB and " + std::to_string(bounds_.repeats) +
         " times its size; export it with fewer copies");
  }

  /// The same for memory that an accessor's data fill; reads them, which raises the limit.
  void spend(const GltfAccessor& accessor, std::uint64_t bytes) {
    data_of(accessor);
    spend(bytes);
  }

  /// Attributes that become arrays: neither positions nor what skeletons move them by.
  static bool is_array(std::string_view semantic) {
    return semantic != "POSITION" && !semantic.starts_with("JOINTS_") &&
           !semantic.starts_with("WEIGHTS_");
  }

  /// Primitives share their vertices if they have all these in common.
  using Attributes = std::map<std::string, std::uint64_t>;

  static Attributes shared_attributes(Attributes attributes) {
    std::erase_if(attributes, [](const auto& entry) {
      return entry.first != "POSITION" && !is_array(entry.first);
    });
    return attributes;
  }

  /// The number of the first of a primitive's vertices.
  Index add_vertices(const GltfPrimitive& primitive, const GltfAccessor& positions,
                     const Affine3d& transform) {
    const auto [entry, is_new] = first_vertex_.try_emplace(
        shared_attributes(primitive.attributes), static_cast<Index>(builder_.vertex_count()));
    if (!is_new) return entry->second;
    if (builder_.vertex_count() + positions.count > 0xfffffffe) {
      fail("has more vertices than brindle can number; split it into parts");
    }
    spend(positions, positions.count * sizeof(Vector3d));
    const double one = unit_of(positions);
    with_number_type(positions.type, [&]<class Number>(Number) {
      for_each_element(positions, 3 * sizeof(Number), [&](const char* bytes) {
        Vector3d position = vector_at<Number>(bytes) / one;
        if (one > 1) position = position.cwiseMax(-1);  // the lowest number is a step beyond it
        builder_.add_vertex(transform * position);
      });
    });
    arrays_.add(arrays_of(primitive, transform.linear()));
    return entry->second;
  }

  template <class Number>
  static Vector3d vector_at(const char* bytes) {
    std::array<Number, 3> numbers{};
    std::memcpy(numbers.data(), bytes, sizeof numbers);
    return {static_cast<double>(numbers[0]), static_cast<double>(numbers[1]),
            static_cast<double>(numbers[2])};
  }

  /// The number of an accessor that means 1: whole numbers may be shares of their largest.
  static double unit_of(const GltfAccessor& accessor) {
    return accessor.is_normalized ? largest_of(accessor.type) : 1;
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

  /// The arrays of a primitive's vertices.
  std::vector<DataArray> arrays_of(const GltfPrimitive& primitive, const Eigen::Matrix3d& linear) {
    std::vector<DataArray> arrays;
    for (const auto& [semantic, number] : primitive.attributes) {
      if (!is_array(semantic)) continue;
      const GltfAccessor& accessor = document_.accessors[number];
      // Columns of smaller numbers are padded; nobody stores data like that. Without a view there
      // are only zeros.
      const bool padded = accessor.is_matrix && accessor.type != NumberType::float32;
      if (padded || !accessor.view) continue;
      DataArray array{array_name(semantic), accessor.type, accessor.components, {}};
      const std::size_t row = size_of(array.type) * static_cast<std::size_t>(array.components);
      spend(accessor, row * accessor.count);
      for_each_element(accessor, row, [&](const char* bytes) {
        const auto* begin = reinterpret_cast<const std::byte*>(bytes);
        array.bytes.insert(array.bytes.end(), begin, begin + row);
      });
      if (semantic.starts_with("TEXCOORD_"))
        array = with_v_up(array, unit_of_coordinates(accessor));
      const bool direction = semantic == "NORMAL" || semantic == "TANGENT";
      // Whole numbers of a direction are always shares of their largest.
      if (direction) array = as_floats(array, largest_of(array.type));
      if (semantic == "NORMAL") turn(array, linear.inverse().transpose());
      if (semantic == "TANGENT") turn(array, linear);
      arrays.push_back(std::move(array));
    }
    return arrays;
  }

  /// "normal", "uv", "uv_1", or "speed" for "_SPEED": the format suggests capitals.
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

  /// Whole numbers of texture coordinates are shares of their largest, unless the file uses the
  /// extension that allows others.
  double unit_of_coordinates(const GltfAccessor& accessor) const {
    const auto used = document_.json.find("extensionsUsed");
    const bool any = used != document_.json.end() && used->is_array() &&
                     ranges::find(*used, "KHR_mesh_quantization") != used->end();
    return any ? unit_of(accessor) : largest_of(accessor.type);
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

  /// Turns the vectors of an array by a node's transform.
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
  std::vector<Index> corners_of(const GltfPrimitive& primitive, Index vertices) {
    std::vector<Index> corners;
    if (!primitive.indices) {
      spend(vertices * sizeof(Triangle));  // the positions' data have been read
      for (Index v = 0; v < vertices; ++v) corners.push_back(v);
      return corners;
    }
    const GltfAccessor& indices = document_.accessors[*primitive.indices];
    const std::size_t size = size_of(indices.type);
    spend(indices, indices.count * sizeof(Triangle));
    for_each_element(indices, size, [&](const char* bytes) {
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
  void for_each_element(const GltfAccessor& accessor, std::size_t size, const Use& use) {
    const std::string& data = data_of(accessor);
    const GltfView& view = document_.views[*accessor.view];
    const std::uint64_t stride = std::max<std::uint64_t>(view.stride, size);
    const char* const begin = data.data() + view.offset + accessor.offset;
    for (std::uint64_t i = 0; i < accessor.count; ++i) use(begin + i * stride);
  }

  /// The buffer that has an accessor's numbers.
  const std::string& data_of(const GltfAccessor& accessor) {
    const GltfView& view = document_.views[*accessor.view];
    if (view.is_compressed) {
      fail("is compressed with meshopt, which brindle does not read; export it without");
    }
    return buffers_.buffer(view.buffer);
  }

  std::filesystem::path path_;
  const GltfDocument& document_;
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
  return GltfReader(path, document, bounds).read();
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
