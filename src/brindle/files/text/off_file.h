/// Object File Format: OFF, and its variants with normals, colours or texture coordinates.
#pragma once

#include <filesystem>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Vertices keep the file's order; all but positions and faces is ignored. Throws Error, naming
/// the line, if the file is not as its header says, or is of a binary or n-dimensional variant.
Mesh read_off(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace brindle
