/// The steps by which `SurfaceFile` makes meshes and points of files.
#pragma once

#include <filesystem>

#include "brindle/files.h"
#include "brindle/files/raw_mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// What a mesh file holds, as it has it.
RawMesh read_raw_mesh(const std::filesystem::path& path, const Progress& progress);

/// Joined, repaired and checked, as `read_mesh` says.
LoadedMesh mesh_of(const std::filesystem::path& path, RawMesh raw);

/// The points of a file of VTK.
LoadedPoints points_of(RawMesh raw);

/// Those of any other file.
LoadedPoints read_raw_points(const std::filesystem::path& path);

}  // namespace brindle
