/// Readers and writers of mesh files, one pair per format. All readers throw Error with the line,
/// if there is one, for damaged files, and Cancelled. Vertices keep the file's order.
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

/// Common names of the components of normals.
inline constexpr std::array<std::array<std::string_view, 3>, 3> kNormalNames = {
    {{"nx", "ny", "nz"}, {"normal_x", "normal_y", "normal_z"}, {"normalx", "normaly", "normalz"}}};

/// Wavefront OBJ: vertices and faces. Normals, groups and materials are ignored; `left_out` reports
/// texture coordinates and vertex colours.
RawMesh read_obj(const std::filesystem::path& path, const Progress& progress = {});

/// Vertices only, with normals if there is one per vertex in the same order and no face contradicts
/// that.
LoadedPoints read_obj_points(const std::filesystem::path& path);

/// The format has only normals and texture coordinates as arrays. `materials` names a material
/// library; the mesh then uses its material.
void write_obj(OutputStream& out, const Mesh& mesh, std::span<const DataArray> arrays,
               const std::string& materials = "");

/// A library with the one material that `write_obj` names: a repeating image file.
std::string material_library(const std::string& picture);

/// Object File Format: OFF and its variants. Normals, colours and texture coordinates are ignored.
/// Throws Error for variants of other dimensions than three.
RawMesh read_off(const std::filesystem::path& path, const Progress& progress = {});

/// Stereolithography, text or binary: three vertices per triangle, in the file's order. Normals and
/// colours are ignored.
RawMesh read_stl(const std::filesystem::path& path, const Progress& progress = {});

/// Binary STL, of which each triangle has its own corners.
void write_stl(OutputStream& out, const Mesh& mesh);

/// 3MF, in millimetres: an uncompressed ZIP archive with one object. Throws Error for meshes beyond
/// 4 GB of text, the format's limit.
void write_3mf(OutputStream& out, const Mesh& mesh);

/// Stanford triangle format (PLY), text or binary: positions and faces. Other numeric properties
/// become arrays with the same name and type; some are joined into one array: nx, ny, nz to
/// "normal"; red, green, blue and optional alpha to "color"; texture_u, texture_v or s, t to "uv";
/// and all groups of `grouped_columns`.
RawMesh read_ply(const std::filesystem::path& path, const Progress& progress = {});

/// Vertices only, with normals if the file has them.
LoadedPoints read_ply_points(const std::filesystem::path& path);

/// The elements of the header; edges count as lines.
FileElements ply_elements(const std::filesystem::path& path);

/// Binary, little endian. Arrays, in the form of `fitted_arrays`, become properties of vertices and
/// faces: "normal" nx, ny, nz; "color" red, green, blue; others with the names of `column_names`;
/// "uv" texture_u, texture_v (read by VTK and MeshLab), repeated as s, t (Blender). `picture` is
/// the image file of these coordinates, in a comment that MeshLab introduced.
void write_ply(OutputStream& out, const Mesh& mesh, const DataArrays& arrays,
               const std::string& picture = "");

/// A CSV file with rows x,y,z or x,y,z,nx,ny,nz, or with columns of these names; other columns
/// become arrays.
LoadedPoints read_csv_points(const std::filesystem::path& path);

}  // namespace brindle
