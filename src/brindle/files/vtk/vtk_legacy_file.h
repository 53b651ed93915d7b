/// VTK's legacy files (.vtk), as text or binary, of versions 1 to 5.
#pragma once

#include <filesystem>

#include "brindle/files/raw_mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// As `read_vtk`, which chooses by extension.
RawMesh read_vtk_legacy(const std::filesystem::path& path, const Progress& progress);

}  // namespace brindle
