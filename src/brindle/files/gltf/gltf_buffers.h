/// The data that glTF files hold or name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/files/gltf/gltf_document.h"

namespace brindle {

#ifdef BRINDLE_HAS_JSON

/// The buffers of a checked document, read when they are asked for. All functions throw Error
/// naming the file and the remedy.
class GltfBuffers {
 public:
  /// Both must live on.
  GltfBuffers(const std::filesystem::path& path, const GltfDocument& document)
      : path_(path), document_(document) {}

  /// A buffer's bytes, at least as many as it promises; valid as long as this lives. Throws if
  /// there are fewer, or the buffer's file lies outside the folder of the .gltf: who opens a mesh
  /// of unknown origin does not want it to hold what else is on the machine.
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

#endif  // BRINDLE_HAS_JSON

}  // namespace brindle
