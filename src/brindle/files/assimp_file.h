/// Mesh files read by the Assimp library.
#pragma once

#include <filesystem>

#include "brindle/files/gltf_file.h"
#include "brindle/mesh.h"

namespace brindle {

/// All meshes of all nodes of the file's scene, moved to where the nodes put them, as one. Vertices
/// are as Assimp gives them: several at one place where normals or texture coordinates differ.
/// `root` is that of the scene, and says where nodes stand in more digits than Assimp does.
/// Throws Error with Assimp's reason if it cannot read the file, or was not built in.
Mesh read_with_assimp(const std::filesystem::path& path, const GltfNode& root);

}  // namespace brindle
