/// Readers and writers of mesh files, a format each. All readers throw Error, naming the line where
/// there is one, for a damaged file, and Cancelled if `progress` asks for it. Vertices keep the
/// file's order.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "brindle/base/output_file.h"
#include "brindle/files.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/mesh.h"
#include "brindle/points.h"
#include "brindle/progress.h"

namespace brindle {

/// The names that programs give to the components of normals.
inline constexpr std::array<std::array<std::string_view, 3>, 3> kNormalNames = {
    {{"nx", "ny", "nz"}, {"normal_x", "normal_y", "normal_z"}, {"normalx", "normaly", "normalz"}}};

/// Wavefront OBJ: vertices and faces; normals, groups and materials are ignored, and `left_out`
/// says so of texture coordinates and of colours of vertices.
RawMesh read_obj(const std::filesystem::path& path, const Progress& progress = {});

/// The vertices alone, with normals if there are as many, one each in the same order, and no face
/// contradicts it.
LoadedPoints read_obj_points(const std::filesystem::path& path);

FileElements obj_elements(const std::filesystem::path& path);

/// Normals and texture coordinates are the only arrays that the format has. If `materials`
/// names a material library, the mesh has its material.
void write_obj(OutputStream& out, const Mesh& mesh, std::span<const DataArray> arrays,
               const std::string& materials = "");

/// A library of the one material that `write_obj` names: a picture file, repeated beyond its
/// borders.
std::string material_library(const std::string& picture);

/// Object File Format: OFF, and its variants with normals, colours or texture coordinates, which
/// are ignored. Throws Error for variants in other than three dimensions, too.
RawMesh read_off(const std::filesystem::path& path, const Progress& progress = {});

/// Stereolithography, text or binary: three vertices per triangle, in the file's order; normals and
/// colours are ignored.
RawMesh read_stl(const std::filesystem::path& path, const Progress& progress = {});

/// Stanford triangle format (PLY), text or binary: positions and faces. Further properties that are
/// one number become arrays of that name and type, some together one array of several components:
/// nx, ny, nz "normal"; red, green, blue and, where there is one, alpha "color"; texture_u,
/// texture_v or s, t "uv"; and those that `grouped_columns` joins.
RawMesh read_ply(const std::filesystem::path& path, const Progress& progress = {});

/// The vertices alone, with their normals if each has them.
LoadedPoints read_ply_points(const std::filesystem::path& path);

/// What the header names; lines are edges.
FileElements ply_elements(const std::filesystem::path& path);

/// Binary, little endian. Arrays, as `fitted_arrays` makes them, become properties of vertices and
/// faces: "normal" nx, ny, nz; "color" red, green, blue; others with the names of `column_names`;
/// "uv" texture_u, texture_v (which VTK and MeshLab read) and the same again as s, t (Blender).
/// `picture` names the file that these refer to, in a comment that MeshLab introduced.
void write_ply(OutputStream& out, const Mesh& mesh, const DataArrays& arrays,
               const std::string& picture = "");

/// A CSV file with rows x,y,z or x,y,z,nx,ny,nz, or with columns of these names among others, which
/// become arrays.
LoadedPoints read_csv_points(const std::filesystem::path& path);

}  // namespace brindle
