/// What a glTF 2.0 file says, checked. Only builds with nlohmann-json have it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#ifdef BRINDLE_HAS_JSON

#include <nlohmann/json.hpp>

#include "brindle/progress.h"

namespace brindle {

/// Words of a GLB file: "glTF", "JSON" and "BIN".
inline constexpr std::uint32_t kGltfMagic = 0x46546c67;
inline constexpr std::uint32_t kGltfJsonChunk = 0x4e4f534a;
inline constexpr std::uint32_t kGltfDataChunk = 0x004e4942;

struct GltfDocument {
  nlohmann::json json;
  std::string data;  ///< a GLB's own buffer
};

/// Throws Error if the file is truncated, or its nodes or accessors are not what the format asks
/// for: circles among nodes, numbers of parts that do not exist, data beyond the end of a buffer.
/// Who reads the document may rely on all that.
GltfDocument read_gltf_document(const std::filesystem::path& path, const Progress& progress);

}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
