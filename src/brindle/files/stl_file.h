/// Stereolithography files: STL, text or binary.
#pragma once

#include <filesystem>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Three vertices per triangle, in the file's order; normals and colours are ignored. Throws Error,
/// naming the line in a text file, if the file is neither a whole text nor a whole binary STL file.
Mesh read_stl(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace brindle
