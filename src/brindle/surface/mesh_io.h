/// Meshes from and to files.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brindle/surface/mesh.h"
#include "brindle/surface/mesh_repair.h"
#include "brindle/surface/vertex_attribute.h"

namespace brindle {

struct LoadedMesh {
  Mesh mesh;
  MeshRepair repair;  ///< what was wrong with the file's mesh
  /// For every vertex of the file, in its order, the vertex that triangles use in its place:
  /// itself, or the first at the same place. Empty if nothing was joined.
  std::vector<Index> vertex_of_row;
  bool renumbered = false;  ///< joined vertices were removed, and the others have new numbers
};

/// Reads OBJ, PLY, OFF, STL, glTF and GLB, told apart by the path's extension; polygons are cut
/// into triangles, and all objects of the file become one mesh.
///
/// Vertices of OBJ, PLY and OFF files keep their numbers, so that data per vertex match, whether or
/// not a triangle uses them. In every format, triangles use the first of all vertices that stand
/// at exactly one place: files often repeat vertices along seams of texture, or for every
/// triangle. The others stay behind unreferenced; in an STL file, which has no numbers, they are
/// removed. Coordinates that are large against the mesh's size are made relative to `Mesh::origin`.
///
/// All but glTF and GLB is read here and not by Assimp: its readers renumber vertices, know floats
/// alone, and those for PLY and OFF crash or hang on damaged files (Assimp 5.2.5).
///
/// Throws Error, naming the file, the line where there is one, and the remedy, for a path that
/// cannot be read, an unknown extension, a damaged file, or a file without a usable triangle.
LoadedMesh read_mesh(const std::filesystem::path& path);

/// The vertices that `read_mesh` reads, of a file with or without triangles. Coordinates that are
/// no numbers stay so. Throws Error as `read_mesh` does.
Mesh read_vertices(const std::filesystem::path& path);

/// Writes OBJ, PLY (binary), VTP, glTF or GLB by the path's extension, whole or not at all.
/// Throws Error for an unknown extension; for attributes that the format cannot hold, that have a
/// bad name, or do not have 1 or 3 values ("uv": 2) for every vertex; and what write_file throws.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh,
                std::span<const VertexAttribute> attributes = {});

/// Writes a mesh that shows a picture at its texture coordinates, which repeats beyond its borders.
/// `attributes` has "uv"; `png` is a PNG file's content. glTF and GLB hold the picture; for others
/// it is written beside the mesh, for OBJ with a material library: `textured_mesh_files`. Throws
/// Error as `write_mesh` does, and if "uv" is missing.
void write_textured_mesh(const std::filesystem::path& path, const Mesh& mesh,
                         std::span<const VertexAttribute> attributes, const std::string& png);

/// All files that `write_textured_mesh` writes for `path`, that itself last.
std::vector<std::filesystem::path> textured_mesh_files(const std::filesystem::path& path);

}  // namespace brindle
