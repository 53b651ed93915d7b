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

constexpr std::uint64_t kBytesOfPrimitive = 64;  ///< also without triangles

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
    if (morphed_ > 0) {
      left_out +=
          std::to_string(morphed_) +
          " meshes with weights of morph targets: these are left out, the meshes have their "
          "base shapes\n";
    }
    RawMesh raw = builder_.take(std::move(arrays));
    raw.left_out = std::move(left_out);
    return raw;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(shown(path_.string()) + ": " + what);
  }

  /// A node's list of `count` numbers; empty if it has none of that name.
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
      note_morphing(node);
      const std::vector<Affine3d> joints = joints_of(node);
      for (const Affine3d& instance : instances_of(node)) {
        first_vertex_.clear();
        for (const GltfPrimitive& primitive : document_.meshes[*node.mesh]) {
          add_primitive(primitive, {transform * instance, joints});
        }
      }
    }
    for (const std::uint64_t child : node.children) add_node(child, transform);
  }

  void note_morphing(const GltfNode& node) {
    const auto has_weights = [](const Json& json) {
      const auto weights = json.find("weights");
      return weights != json.end() && weights->is_array() &&
             ranges::any_of(*weights, [](const Json& weight) { return weight != 0; });
    };
    const bool has_targets =
        ranges::any_of(document_.meshes[*node.mesh],
                       [](const GltfPrimitive& primitive) { return primitive.has_targets; });
    const bool has_own = node.json->contains("weights");
    const Json& weighted = has_own ? *node.json : document_.json["meshes"][*node.mesh];
    if (has_targets && has_weights(weighted)) ++morphed_;
  }

  /// Instances of the node's mesh, relative to the node.
  std::vector<Affine3d> instances_of(const GltfNode& node) {
    if (node.instances.empty()) return {Affine3d::Identity()};
    const std::uint64_t count = document_.accessors[node.instances.begin()->second].count;
    std::map<std::string, std::vector<double>> numbers;
    for (const auto& [name, accessor] : node.instances) {
      numbers[name] = numbers_of(document_.accessors[accessor]);
    }
    spend(count * sizeof(Affine3d));
    std::vector<Affine3d> instances(count, Affine3d::Identity());
    for (std::size_t i = 0; i < count; ++i) {
      const auto row = [&](const char* name, std::size_t columns) -> const double* {
        const auto found = numbers.find(name);
        return found == numbers.end() ? nullptr : &found->second[i * columns];
      };
      if (const double* t = row("TRANSLATION", 3)) instances[i].translate(Vector3d(t));
      if (const double* r = row("ROTATION", 4)) {
        instances[i].rotate(Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized());
      }
      if (const double* s = row("SCALE", 3)) instances[i].scale(Vector3d(s));
    }
    return instances;
  }

  /// The transforms of the joints of the node's skin; empty without a skin.
  std::vector<Affine3d> joints_of(const GltfNode& node) {
    std::vector<Affine3d> joints;
    if (!node.skin) return joints;
    const GltfSkin& skin = document_.skins[*node.skin];
    spend(skin.joints.size() * sizeof(Affine3d));
    std::vector<double> inverse;
    if (skin.inverse_bind_matrices) {
      inverse = numbers_of(document_.accessors[*skin.inverse_bind_matrices]);
    }
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      joints.push_back(in_scene(skin.joints[j]));
      if (inverse.empty()) continue;
      Affine3d bind;
      bind.matrix() = Eigen::Map<const Eigen::Matrix4d>(&inverse[16 * j]);
      joints.back() = joints.back() * bind;
    }
    return joints;
  }

  /// The transform of a node relative to the scene.
  const Affine3d& in_scene(std::uint64_t number) {
    if (in_scene_.empty()) {
      in_scene_.resize(document_.nodes.size());
      for (const std::uint64_t top : document_.tops) place_in_scene(top, Affine3d::Identity());
    }
    return in_scene_[number];
  }

  void place_in_scene(std::uint64_t number, const Affine3d& parent) {
    const GltfNode& node = document_.nodes[number];
    in_scene_[number] = parent * transform_of(*node.json);
    for (const std::uint64_t child : node.children) place_in_scene(child, in_scene_[number]);
  }

  /// Transforms of a node's mesh: skinned vertices follow joints alone.
  struct Place {
    Affine3d transform;
    const std::vector<Affine3d>& joints;

    bool is_skinned(const GltfPrimitive& primitive) const {
      return !joints.empty() && primitive.attributes.contains("JOINTS_0") &&
             primitive.attributes.contains("WEIGHTS_0");
    }
  };

  void add_primitive(const GltfPrimitive& primitive, const Place& place) {
    if (primitive.mode < kTriangles || primitive.mode > kTriangleFan) return;  // points and lines
    if (primitive.is_compressed) {
      fail("is compressed with Draco, which brindle does not read; export it without compression");
    }
    spend(kBytesOfPrimitive);
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return;
    const GltfAccessor& positions = document_.accessors[position->second];
    if (!positions.has_data() ||
        (primitive.indices && !document_.accessors[*primitive.indices].has_data())) {
      ++without_data_;  // zeros by definition: no triangle has an area
      return;
    }
    const std::vector<Affine3d> ways = ways_of(primitive, positions.count, place);
    const Index first = add_vertices(primitive, positions, place, ways);
    std::vector<Index> corners = corners_of(primitive, static_cast<Index>(positions.count));
    for (Index& corner : corners) corner += first;
    add_triangles(corners, static_cast<PrimitiveMode>(primitive.mode),
                  ways.front().linear().determinant() < 0);
  }

  /// The transform of each vertex, or one for all.
  std::vector<Affine3d> ways_of(const GltfPrimitive& primitive, std::uint64_t vertices,
                                const Place& place) {
    if (!place.is_skinned(primitive)) return {place.transform};
    spend(vertices * sizeof(Affine3d));
    std::vector<Eigen::Matrix4d> sums(vertices, Eigen::Matrix4d::Zero());
    for (int set = 0;; ++set) {
      const auto joints = primitive.attributes.find("JOINTS_" + std::to_string(set));
      const auto weights = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
      if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) break;
      const std::vector<double> numbers = numbers_of(document_.accessors[joints->second]);
      const std::vector<double> shares = numbers_of(document_.accessors[weights->second]);
      if (numbers.size() != 4 * vertices || shares.size() != 4 * vertices) {
        fail("is a damaged glTF file, export it again: joints and weights must be of four numbers");
      }
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (shares[i] == 0) continue;
        if (!(numbers[i] < static_cast<double>(place.joints.size()))) {
          fail("is a damaged glTF file, export it again: a vertex has a joint that does not exist");
        }
        sums[i / 4] += shares[i] * place.joints[static_cast<std::size_t>(numbers[i])].matrix();
      }
    }
    std::vector<Affine3d> ways(vertices, Affine3d::Identity());
    for (std::size_t v = 0; v < vertices; ++v) {
      const double all = sums[v](3, 3);  // sum of weights, up to rounding
      if (all > 0) ways[v].matrix() = sums[v] / all;
    }
    return ways;
  }

  /// Throws if a small file requests so much memory in total.
  void spend(std::uint64_t bytes) {
    spent_ += bytes;
    if (spent_ <= bounds_.bytes + bounds_.repeats * buffers_.size()) return;
    fail("repeats its meshes and data until they have more than " +
         std::to_string(bounds_.bytes >> 20) + " MiB and " + std::to_string(bounds_.repeats) +
         " times its size; export it with fewer copies");
  }

  /// The same for memory that an accessor's data fill; reading them raises the limit.
  void spend(const GltfAccessor& accessor, std::uint64_t bytes) {
    if (accessor.view) data_of(*accessor.view);
    if (accessor.sparse) data_of(accessor.sparse->value_view);
    spend(bytes);
  }

  /// Whether an attribute becomes an array: neither positions nor skinning data.
  static bool is_array(std::string_view semantic) {
    return semantic != "POSITION" && !semantic.starts_with("JOINTS_") &&
           !semantic.starts_with("WEIGHTS_");
  }

  /// Primitives with equal attributes share their vertices.
  using Attributes = std::map<std::string, std::uint64_t>;

  static Attributes shared_attributes(Attributes attributes, bool skinned) {
    std::erase_if(attributes, [&](const auto& entry) {
      return entry.first != "POSITION" && !is_array(entry.first) && !skinned;
    });
    return attributes;
  }

  /// The index of a primitive's first vertex.
  Index add_vertices(const GltfPrimitive& primitive, const GltfAccessor& positions,
                     const Place& place, const std::vector<Affine3d>& ways) {
    const auto [entry, is_new] = first_vertex_.try_emplace(
        shared_attributes(primitive.attributes, place.is_skinned(primitive)),
        static_cast<Index>(builder_.vertex_count()));
    if (!is_new) return entry->second;
    if (builder_.vertex_count() + positions.count > 0xfffffffe) {
      fail("has more vertices than brindle can number; split it into parts");
    }
    spend(positions, positions.count * sizeof(Vector3d));
    const double one = unit_of(positions);
    std::size_t vertex = 0;
    with_number_type(positions.type, [&]<class Number>(Number) {
      for_each_element(positions, 3 * sizeof(Number), [&](const char* bytes) {
        Vector3d position = vector_at<Number>(bytes) / one;
        if (one > 1) position = position.cwiseMax(-1);  // the least integer is a step below -1
        builder_.add_vertex(way_of(ways, vertex++) * position);
      });
    });
    arrays_.add(arrays_of(primitive, ways));
    return entry->second;
  }

  static const Affine3d& way_of(const std::vector<Affine3d>& ways, std::size_t vertex) {
    return ways.size() > 1 ? ways[vertex] : ways.front();
  }

  template <class Number>
  static Vector3d vector_at(const char* bytes) {
    std::array<Number, 3> numbers{};
    std::memcpy(numbers.data(), bytes, sizeof numbers);
    return {static_cast<double>(numbers[0]), static_cast<double>(numbers[1]),
            static_cast<double>(numbers[2])};
  }

  /// The stored number that means 1: normalized integers are divided by their maximum.
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
  std::vector<DataArray> arrays_of(const GltfPrimitive& primitive,
                                   const std::vector<Affine3d>& ways) {
    std::vector<DataArray> arrays;
    for (const auto& [semantic, number] : primitive.attributes) {
      if (!is_array(semantic)) continue;
      const GltfAccessor& accessor = document_.accessors[number];
      // Columns of narrow integer matrices are padded; such arrays are left out, as are those
      // without data, which are zeros.
      const bool padded = accessor.is_matrix && accessor.type != NumberType::float32;
      if (padded || !accessor.has_data()) continue;
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
      // Integer directions are always normalized.
      if (direction) array = as_floats(array, largest_of(array.type));
      if (semantic == "NORMAL") {
        turn(array, ways, [](const Affine3d& way) -> Eigen::Matrix3d {
          return way.linear().inverse().transpose();
        });
      }
      if (semantic == "TANGENT") {
        turn(array, ways, [](const Affine3d& way) -> Eigen::Matrix3d { return way.linear(); });
      }
      arrays.push_back(std::move(array));
    }
    return arrays;
  }

  /// "normal", "uv", "uv_1", or "speed" for "_SPEED": the format suggests upper case.
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

  /// Integer texture coordinates are normalized, unless the file uses the extension that allows
  /// others.
  double unit_of_coordinates(const GltfAccessor& accessor) const {
    const auto used = document_.json.find("extensionsUsed");
    const bool any = used != document_.json.end() && used->is_array() &&
                     ranges::find(*used, "KHR_mesh_quantization") != used->end();
    return any ? unit_of(accessor) : largest_of(accessor.type);
  }

  /// Divides by `one` and clamps at -1: the least integer is a step below.
  static DataArray as_floats(const DataArray& array, double one) {
    if (array.type == NumberType::float32) return array;
    std::vector<float> numbers;
    for_each_number(array.view(), [&](std::size_t, std::size_t, auto number) {
      numbers.push_back(static_cast<float>(std::max(-1.0, static_cast<double>(number) / one)));
    });
    return make_data_array(array.name, array.components, numbers);
  }

  /// Float texture coordinates with V up; glTF has V down.
  static DataArray with_v_up(const DataArray& array, double one) {
    std::vector<float> numbers;
    for_each_number(array.view(), [&](std::size_t, std::size_t column, auto number) {
      const auto value = static_cast<float>(static_cast<double>(number) / one);
      numbers.push_back(column == 1 ? 1 - value : value);
    });
    return make_data_array(array.name, array.components, numbers);
  }

  /// Transforms the vectors of an array by a matrix per vertex.
  template <class MatrixOf>
  static void turn(DataArray& array, const std::vector<Affine3d>& ways, const MatrixOf& matrix_of) {
    const bool vectors = array.type == NumberType::float32 && array.components >= 3;
    if (!vectors) return;
    const std::size_t row = sizeof(float) * static_cast<std::size_t>(array.components);
    Eigen::Matrix3d linear = matrix_of(ways.front());
    for (std::size_t v = 0; v < array.rows(); ++v) {
      if (ways.size() > 1) linear = matrix_of(ways[v]);
      if (linear.isIdentity(0)) continue;
      Vec3 vector;
      std::memcpy(vector.data(), &array.bytes[v * row], sizeof vector);
      vector = (linear * vector.cast<double>()).stableNormalized().cast<float>();
      std::memcpy(&array.bytes[v * row], vector.data(), sizeof vector);
    }
  }

  /// The vertex of each corner of a primitive, counted from its first vertex.
  std::vector<Index> corners_of(const GltfPrimitive& primitive, Index vertices) {
    std::vector<Index> corners;
    if (!primitive.indices) {
      spend(vertices * sizeof(Triangle));  // the positions are read by now
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
      // Mirroring reverses triangles, and so does every second triangle of a strip.
      const bool odd = mode == kTriangleStrip && c % 2 == 1;
      if (odd != mirrored) std::swap(triangle[1], triangle[2]);
      builder_.add_polygon(triangle);
    }
  }

  /// All numbers of an accessor, scaled by `unit_of`.
  std::vector<double> numbers_of(const GltfAccessor& accessor) {
    const auto columns = static_cast<std::size_t>(accessor.components);
    if (!accessor.has_data()) fail("is a damaged glTF file, export it again: data are missing");
    spend(accessor, accessor.count * columns * sizeof(double));
    std::vector<double> numbers;
    const double one = unit_of(accessor);
    with_number_type(accessor.type, [&]<class Number>(Number) {
      for_each_element(accessor, columns * sizeof(Number), [&](const char* bytes) {
        for (std::size_t c = 0; c < columns; ++c) {
          Number number;
          std::memcpy(&number, bytes + c * sizeof number, sizeof number);
          const double value = static_cast<double>(number) / one;
          numbers.push_back(one > 1 ? std::max(-1.0, value) : value);
        }
      });
    });
    return numbers;
  }

  /// Calls `use` with the first byte of every element of `size` bytes.
  template <class Use>
  void for_each_element(const GltfAccessor& accessor, std::size_t size, const Use& use) {
    if (accessor.sparse) {
      const std::string elements = all_elements(accessor, size);
      for (std::uint64_t i = 0; i < accessor.count; ++i) use(elements.data() + i * size);
    } else {
      for_each_in_view(accessor, size, use);
    }
  }

  template <class Use>
  void for_each_in_view(const GltfAccessor& accessor, std::size_t size, const Use& use) {
    const std::uint64_t stride =
        std::max<std::uint64_t>(document_.views[*accessor.view].stride, size);
    const char* const begin = data_of(*accessor.view) + accessor.offset;
    for (std::uint64_t i = 0; i < accessor.count; ++i) use(begin + i * stride);
  }

  /// The elements of a sparse accessor, in one sequence.
  std::string all_elements(const GltfAccessor& accessor, std::size_t size) {
    std::string elements;
    elements.reserve(accessor.count * size);
    if (accessor.view) {
      for_each_in_view(accessor, size, [&](const char* bytes) { elements.append(bytes, size); });
    } else {
      elements.assign(accessor.count * size, '\0');
    }
    const GltfSparse& sparse = *accessor.sparse;
    const char* index_bytes = data_of(sparse.index_view) + sparse.index_offset;
    const char* values = data_of(sparse.value_view) + sparse.value_offset;
    for (std::uint64_t i = 0; i < sparse.count; ++i, index_bytes += size_of(sparse.index_type)) {
      std::uint32_t index = 0;  // little endian, as the format is
      std::memcpy(&index, index_bytes, size_of(sparse.index_type));
      if (index >= accessor.count) {
        fail(
            "is a damaged glTF file, export it again: a sparse accessor names an element that "
            "does not exist");
      }
      std::memcpy(&elements[index * size], values + i * size, size);
    }
    return elements;
  }

  /// The first byte of a view.
  const char* data_of(std::uint64_t number) {
    const GltfView& view = document_.views[number];
    if (view.is_compressed) {
      fail("is compressed with meshopt, which brindle does not read; export it without");
    }
    return buffers_.buffer(view.buffer).data() + view.offset;
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
  std::size_t morphed_ = 0;         ///< meshes with weights of morph targets
  std::vector<Affine3d> in_scene_;  ///< of nodes; filled on demand
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
