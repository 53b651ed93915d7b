/// glTF 2.0 files, as text or binary (GLB).
#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "brindle/files.h"
#include "brindle/mesh.h"

namespace brindle {

/// Where a node stands in its parent, in doubles, for which Assimp has no place.
struct GltfNode {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  std::vector<GltfNode> children;
};

/// Throws Error if the file is truncated, or its nodes or accessors are not what the format asks
/// for: circles among nodes, data beyond the end of a buffer. Assimp relies on that. Returns the
/// nodes of the scene that is shown: its only root, or a node that has all roots as children.
GltfNode check_gltf(const std::filesystem::path& path);

enum class GltfKind { text, binary };

/// The text form holds its data too, in base64. "normal" is stored as NORMAL, "color" as COLOR_0,
/// "uv" as TEXCOORD_0 (whose V runs down), others under their name in capitals after an underscore.
/// `png`, a PNG file's content, becomes the mesh's material, repeated beyond its borders. Throws
/// Error for a mesh without triangles, and for data beyond 4 GB, which the format cannot hold.
void write_gltf(std::ostream& out, const Mesh& mesh, std::span<const VertexAttribute> attributes,
                GltfKind kind, const std::string& png = "");

}  // namespace brindle
