/// Meshes from glTF 2.0 files, as text (.gltf) or binary (.glb).
#pragma once

#include <filesystem>

#include "brindle/files/raw_mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// All triangles, strips and fans of all meshes of the file's scene, moved to where its nodes put
/// them, as one mesh. Vertices stand in the order of nodes, primitives and accessors; primitives of
/// one node that share their positions share vertices. Attributes that all primitives have become
/// arrays of points: "normal", "tangent", "uv" (floats, V up), "uv_1", "color", and those of
/// applications without their underscore, in small letters if they have no others; normals and
/// tangents are turned with their nodes. Throws Error, naming the file and the remedy, for damaged
/// files, missing buffers, and geometry that needs an extension (Draco and meshopt compression,
/// quantisation); and in a build without nlohmann-json.
RawMesh read_gltf(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace brindle
