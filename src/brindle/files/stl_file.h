/// Stereolithography files: STL, text or binary.
#pragma once

#include <filesystem>

namespace brindle {

/// Throws Error if the file is neither a whole text nor a whole binary STL file. Assimp, which
/// reads them, takes half a text file for a whole one.
void check_stl(const std::filesystem::path& path);

}  // namespace brindle
