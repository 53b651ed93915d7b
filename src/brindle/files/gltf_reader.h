/// Meshes from glTF 2.0 files, as text (.gltf) or binary (.glb).
#pragma once

#include <filesystem>

#include "brindle/mesh.h"

namespace brindle {

/// All triangles, strips and fans of all meshes of the file's scene, moved to where its nodes put
/// them, as one mesh. Vertices stand in the order of nodes, primitives and accessors; primitives of
/// one node that share their positions share vertices. Throws Error, naming the file and the
/// remedy, for damaged files, missing buffers, and geometry that needs an extension (Draco and
/// meshopt compression, quantisation); and in a build without nlohmann-json.
Mesh read_gltf(const std::filesystem::path& path);

}  // namespace brindle
