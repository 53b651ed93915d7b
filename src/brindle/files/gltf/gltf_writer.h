/// Meshes to glTF 2.0 files, as text or binary (GLB).
#pragma once

#include <span>
#include <string>

#include "brindle/base/output_file.h"
#include "brindle/files.h"
#include "brindle/mesh.h"

namespace brindle {

enum class GltfKind { text, binary };

/// The text form holds its data too, in base64. Arrays, as `fitted_arrays` makes them, are stored
/// under their names, but "normal" as NORMAL, "color" as COLOR_0, "uv" as TEXCOORD_0 (whose V runs
/// down).
/// `png`, a PNG file's content, becomes the mesh's material, repeated beyond its borders. Throws
/// Error for a mesh without triangles, and for data beyond 4 GB, which the format cannot hold.
void write_gltf(OutputStream& out, const Mesh& mesh, std::span<const DataArray> arrays,
                GltfKind kind, const std::string& png = "");

}  // namespace brindle
