/// glTF 2.0 files, as text (.gltf) or binary (.glb).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "brindle/base/output_file.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/progress.h"

namespace brindle {

/// Limits of memory: a small file can demand any amount, because nodes may repeat meshes and
/// primitives may share data. `bytes` are allowed, and `repeats` more for every byte of data.
struct GltfBounds {
  std::uint64_t bytes = std::uint64_t{1} << 31;
  std::uint64_t repeats = 20;
};

/// All triangles, strips and fans of all meshes of the file's scene, transformed by its nodes, as
/// one mesh. Vertices stand in the order of nodes, primitives and accessors; primitives of
/// one node that share all attributes share vertices. Attributes that all primitives have become
/// arrays of points: "normal", "tangent", "uv" (floats, V up), "uv_1", "color", and those of
/// applications without their underscore, in small letters if they have no others; normals and
/// tangents are turned with their nodes. Whole numbers of positions, normals, tangents and
/// texture coordinates (KHR_mesh_quantization) are converted. Throws Error,
/// naming the file and the remedy, for damaged files, missing buffers and those outside the file's
/// folder, geometry that needs an extension (Draco and meshopt compression), and files that repeat
/// little data until it is beyond the bounds; and in a build without nlohmann-json.
RawMesh read_gltf(const std::filesystem::path& path, const Progress& progress = {},
                  const GltfBounds& bounds = {});

enum class GltfKind { text, binary };

/// The text form holds its data too, in base64. Arrays, as `fitted_arrays` makes them, are stored
/// under their names, but "normal" as NORMAL, "color" as COLOR_0, "uv" as TEXCOORD_0 (whose V runs
/// down).
/// `png`, a PNG file's content, becomes the mesh's material, repeated beyond its borders. Throws
/// Error for a mesh without triangles, and for data beyond 4 GB, which the format cannot hold.
void write_gltf(OutputStream& out, const Mesh& mesh, std::span<const DataArray> arrays,
                GltfKind kind, const std::string& png = "");

}  // namespace brindle
