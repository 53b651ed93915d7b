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

/// Memory limits. A small file can demand any amount, because nodes may repeat meshes and
/// primitives may share data. Allowed are `bytes`, and `repeats` more for each byte of data.
struct GltfBounds {
  std::uint64_t bytes = std::uint64_t{1} << 31;
  std::uint64_t repeats = 20;
};

/// All triangles, strips and fans of all meshes of the file's scene as one mesh, transformed by its
/// nodes. Vertices are in the order of nodes, primitives and accessors; primitives of one node with
/// the same attributes share vertices. Attributes that all primitives have become arrays of points:
/// "normal", "tangent", "uv" (floats, V up), "uv_1", "color", and application attributes without
/// their underscore, upper-case names in lower case. Nodes transform normals and tangents.
/// Quantized positions, normals, tangents and texture coordinates (KHR_mesh_quantization) are
/// converted. Throws Error with the file and the remedy for damaged files, missing buffers or those
/// outside the file's folder, compressed geometry (Draco, meshopt), files beyond the bounds, and in
/// builds without nlohmann-json.
RawMesh read_gltf(const std::filesystem::path& path, const Progress& progress = {},
                  const GltfBounds& bounds = {});

enum class GltfKind { text, binary };

/// The text form embeds its data in base64. Arrays, in the form of `fitted_arrays`, keep their
/// names, except for "normal" (NORMAL), "color" (COLOR_0) and "uv" (TEXCOORD_0, V down). `png`, the
/// content of a PNG file, becomes the repeating texture of the mesh's material. Throws Error for a
/// mesh without triangles, and for more than 4 GB, the format's limit.
void write_gltf(OutputStream& out, const Mesh& mesh, std::span<const DataArray> arrays,
                GltfKind kind, const std::string& png = "");

}  // namespace brindle
