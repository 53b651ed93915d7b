/// Telling files apart by their names.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace brindle {

/// The path's extension with its dot, in small letters: ".ply" for "Scan.PLY".
inline std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace brindle
