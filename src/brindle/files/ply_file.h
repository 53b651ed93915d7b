/// Polygon File Format, or Stanford triangle format: PLY, text or binary.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "brindle/base/output_file.h"
#include "brindle/files.h"
#include "brindle/files/raw_mesh.h"
#include "brindle/mesh.h"
#include "brindle/points.h"
#include "brindle/progress.h"

namespace brindle {

/// Reads positions and faces; vertices keep the file's order. Further properties that are one
/// number become arrays of that name and type, some together one array of several components: nx,
/// ny, nz "normal"; red, green, blue and, where there is one, alpha "color"; texture_u, texture_v
/// or s, t "uv"; and what `grouped_columns` joins. Throws Error, naming the line where there is
/// one, if the file is not as its header says.
RawMesh read_ply(const std::filesystem::path& path, const Progress& progress = {});

/// The vertices alone, with their normals if each has nx, ny and nz. Throws as `read_ply` does.
LoadedPoints read_ply_points(const std::filesystem::path& path);

/// Whether the header names faces. Throws as `read_ply` does for what is wrong with the header.
bool ply_has_faces(const std::filesystem::path& path);

/// Binary, little endian. Arrays, as `fitted_arrays` makes them, become properties of vertices and
/// faces: "normal" nx, ny, nz; "color" red, green, blue; others with the names of `column_names`;
/// "uv" texture_u, texture_v (which VTK and MeshLab read) and the same again as s, t (Blender).
/// `picture` names the file that these refer to, in a comment that MeshLab introduced.
void write_ply(OutputStream& out, const Mesh& mesh, const DataArrays& arrays,
               const std::string& picture = "");

}  // namespace brindle
