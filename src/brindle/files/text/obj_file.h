/// Wavefront OBJ: vertices and faces.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "brindle/base/output_file.h"
#include "brindle/files.h"
#include "brindle/mesh.h"
#include "brindle/points.h"
#include "brindle/progress.h"

namespace brindle {

/// Vertices keep the file's order; texture coordinates, normals, groups and materials are ignored.
/// Throws Error, naming the line, for coordinates that are no numbers and for faces with fewer than
/// three corners or with corners that do not exist.
Mesh read_obj(const std::filesystem::path& path, const Progress& progress = {});

/// The vertices alone, with normals if there are as many, one each in the same order, and no face
/// says otherwise. Throws
/// Error, naming the line, for coordinates that are no numbers.
LoadedPoints read_obj_points(const std::filesystem::path& path);

bool obj_has_faces(const std::filesystem::path& path);

/// Normals and texture coordinates are the only arrays that the format has. If `materials`
/// names a material library, the mesh has its material.
void write_obj(OutputStream& out, const Mesh& mesh, std::span<const DataArray> arrays,
               const std::string& materials = "");

/// A library of the one material that `write_obj` names: a picture file, repeated beyond its
/// borders.
std::string material_library(const std::string& picture);

}  // namespace brindle
