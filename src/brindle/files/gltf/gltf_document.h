/// What a glTF 2.0 file says, read once and checked. Only builds with nlohmann-json have it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#ifdef BRINDLE_HAS_JSON

#include <nlohmann/json.hpp>

#include "brindle/arrays.h"
#include "brindle/progress.h"

namespace brindle {

/// Words of a GLB file: "glTF", "JSON" and "BIN".
inline constexpr std::uint32_t kGltfMagic = 0x46546c67;
inline constexpr std::uint32_t kGltfJsonChunk = 0x4e4f534a;
inline constexpr std::uint32_t kGltfDataChunk = 0x004e4942;

/// A part of a buffer.
struct GltfView {
  std::uint64_t buffer = 0, offset = 0, length = 0, stride = 0;
  bool is_compressed = false;  ///< by meshopt
};

/// Elements of an array that are not those of its view.
struct GltfSparse {
  std::uint64_t count = 0;
  NumberType index_type = NumberType::uint32;
  std::uint64_t index_view = 0, index_offset = 0;
  std::uint64_t value_view = 0, value_offset = 0;
};

/// An array; its numbers lie within its view.
struct GltfAccessor {
  NumberType type = NumberType::float32;
  int components = 1;
  bool is_matrix = false;
  bool is_normalized = false;         ///< whole numbers are shares of their largest
  std::uint64_t count = 0;            ///< elements, 1 or more
  std::optional<std::uint64_t> view;  ///< without one all numbers are 0, or compressed
  std::uint64_t offset = 0;           ///< in the view
  std::optional<GltfSparse> sparse;

  bool has_data() const { return view || sparse; }
};

struct GltfPrimitive {
  std::uint64_t mode = 4;
  std::map<std::string, std::uint64_t> attributes;  ///< accessors of equally many elements
  std::optional<std::uint64_t> indices;             ///< an accessor of unsigned whole numbers
  bool is_compressed = false;                       ///< by Draco
  bool has_targets = false;                         ///< of morphing
};

struct GltfSkin {
  std::vector<std::uint64_t> joints;                   ///< nodes
  std::optional<std::uint64_t> inverse_bind_matrices;  ///< an accessor with one for each joint
};

struct GltfNode {
  const nlohmann::json* json = nullptr;  ///< for its transform, which is not checked
  std::optional<std::uint64_t> mesh, skin;
  std::vector<std::uint64_t> children;
  /// Accessors of EXT_mesh_gpu_instancing, of equally many elements.
  std::map<std::string, std::uint64_t> instances;
};

/// Numbers of views, accessors, meshes, nodes, skins and buffers exist, and nodes form trees.
struct GltfDocument {
  nlohmann::json json;
  std::string data;  ///< a GLB's own buffer
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<std::vector<GltfPrimitive>> meshes;
  std::vector<GltfNode> nodes;
  std::vector<GltfSkin> skins;
  std::vector<std::uint64_t> tops;  ///< all nodes without a parent
  /// The nodes of the default scene; of a file without scenes, all nodes without a parent.
  std::vector<std::uint64_t> roots;
};

/// Throws Error, naming the file and the remedy, if the file is of another version, requires an
/// extension that brindle does not know, is truncated, or its nodes or accessors are not what the
/// format demands: cycles of nodes, parts that do not exist, data beyond the end of a buffer.
GltfDocument read_gltf_document(const std::filesystem::path& path, const Progress& progress);

/// The buffers of a document, read when they are first used. All functions throw Error naming the
/// file and the remedy.
class GltfBuffers {
 public:
  /// Both must live on.
  GltfBuffers(const std::filesystem::path& path, const GltfDocument& document)
      : path_(path), document_(document) {}

  /// A buffer's bytes, at least as many as it promises; valid as long as this lives. Throws if
  /// there are fewer, or the buffer's file lies outside the folder of the .gltf: a mesh of unknown
  /// origin must not read other files of the machine.
  const std::string& buffer(std::uint64_t index);

  /// How many bytes have been read.
  std::uint64_t size() const { return size_; }

 private:
  [[noreturn]] void fail(const std::string& what) const;
  const std::string& content_of(const nlohmann::json& buffer);
  const std::string& content_of_uri(const std::string& uri);

  const std::filesystem::path& path_;
  const GltfDocument& document_;
  std::map<std::string, std::string> contents_;  ///< by URI, which buffers may share
  std::uint64_t size_ = 0;
};

}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
