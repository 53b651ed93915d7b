/// Meshes from glTF 2.0 files, as text (.gltf) or binary (.glb).
#pragma once

#include <cstdint>
#include <filesystem>

#include "brindle/files/raw_mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Few bytes of a file can ask for as many as they like, because meshes may stand at many nodes and
/// primitives may share their data. So many are given, and so many more for every byte of data.
struct GltfBounds {
  std::uint64_t bytes = std::uint64_t{1} << 31;
  std::uint64_t repeats = 20;
};

/// All triangles, strips and fans of all meshes of the file's scene, moved to where its nodes put
/// them, as one mesh. Vertices stand in the order of nodes, primitives and accessors; primitives of
/// one node that share all attributes share vertices. Attributes that all primitives have become
/// arrays of points: "normal", "tangent", "uv" (floats, V up), "uv_1", "color", and those of
/// applications without their underscore, in small letters if they have no others; normals and
/// tangents are turned with their nodes. Whole numbers that stand for positions, normals, tangents
/// and texture coordinates (KHR_mesh_quantization) are read as what they stand for. Throws Error,
/// naming the file and the remedy, for damaged files, missing buffers and those outside the file's
/// folder, geometry that needs an extension (Draco and meshopt compression), and files that repeat
/// little data until it is beyond the bounds; and in a build without nlohmann-json.
RawMesh read_gltf(const std::filesystem::path& path, const Progress& progress = {},
                  const GltfBounds& bounds = {});

}  // namespace brindle
