/// The content of a glTF 2.0 file, read and checked once. Only in builds with nlohmann-json.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#ifdef BRINDLE_HAS_JSON

#include <nlohmann/json.hpp>

#include "brindle/arrays.h"
#include "brindle/progress.h"

namespace brindle {

/// Magic numbers of a GLB file: "glTF", "JSON" and "BIN".
inline constexpr std::uint32_t kGltfMagic = 0x46546c67;
inline constexpr std::uint32_t kGltfJsonChunk = 0x4e4f534a;
inline constexpr std::uint32_t kGltfDataChunk = 0x004e4942;

/// A part of a buffer.
struct GltfView {
  std::uint64_t buffer = 0, offset = 0, length = 0, stride = 0;
  bool is_compressed = false;  ///< by meshopt
};

/// Elements of an array that replace those of its view.
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
  bool is_normalized = false;         ///< integers are divided by their maximum
  std::uint64_t count = 0;            ///< elements, 1 or more
  std::optional<std::uint64_t> view;  ///< empty: all numbers are 0, or compressed
  std::uint64_t offset = 0;           ///< in the view
  std::optional<GltfSparse> sparse;

  bool has_data() const { return view || sparse; }
};

struct GltfPrimitive {
  std::uint64_t mode = 4;
  std::map<std::string, std::uint64_t> attributes;  ///< accessors of equal length
  std::optional<std::uint64_t> indices;             ///< an accessor of unsigned integers
  bool is_compressed = false;                       ///< by Draco
  bool has_targets = false;                         ///< of morph targets
};

struct GltfSkin {
  std::vector<std::uint64_t> joints;                   ///< nodes
  std::optional<std::uint64_t> inverse_bind_matrices;  ///< an accessor with one per joint
};

struct GltfNode {
  const nlohmann::json* json = nullptr;  ///< for its transform, which is not checked here
  std::optional<std::uint64_t> mesh, skin;
  std::vector<std::uint64_t> children;
  /// Accessors of EXT_mesh_gpu_instancing, of equal length.
  std::map<std::string, std::uint64_t> instances;
};

/// Indices of views, accessors, meshes, nodes, skins and buffers are valid, and nodes form trees.
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

/// Throws Error with the file and the remedy for another version, unknown required extensions,
/// truncated files and documents that break the format: cycles of nodes, parts that do not exist,
/// data beyond the end of a buffer.
GltfDocument read_gltf_document(const std::filesystem::path& path, const Progress& progress);

/// The buffers of a document, read on first use. All functions throw Error with the file and the
/// remedy.
class GltfBuffers {
 public:
  /// Both must outlive this object.
  GltfBuffers(const std::filesystem::path& path, const GltfDocument& document)
      : path_(path), document_(document) {}

  /// A buffer's bytes, at least as many as declared; valid during the lifetime of this object.
  /// Throws if there are fewer, or if the file is outside the folder of the .gltf: an untrusted
  /// mesh must not read other files.
  const std::string& buffer(std::uint64_t index);

  /// Bytes read so far.
  std::uint64_t size() const { return size_; }

 private:
  [[noreturn]] void fail(const std::string& what) const;
  const std::string& content_of(const nlohmann::json& buffer);
  const std::string& content_of_uri(const std::string& uri);

  const std::filesystem::path& path_;
  const GltfDocument& document_;
  std::map<std::string, std::string> contents_;  ///< by URI; buffers may share one
  std::uint64_t size_ = 0;
};

}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
