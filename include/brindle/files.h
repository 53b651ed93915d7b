/// Meshes, points, lines, samples and strokes from and to files.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/points.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"
#include "brindle/samples.h"
#include "brindle/strokes.h"

namespace BRINDLE_EXPORT brindle {

/// Arrays that formats store in their own way: "normal" (unit vectors)
/// of 3 floating-point numbers; "color" (red, green, blue) of 3, floating-point from 0 to 1 or
/// uint8 from 0 to 255; "uv" (texture coordinates in sides of the picture, from its lower left
/// corner to the right and up) of 2 floating-point numbers.
bool is_normal(const DataArray& array);
bool is_color(const DataArray& array);
bool is_uv(const DataArray& array);

/// Arrays in the form in which a file holds them.
struct FittedArrays {
  DataArrays arrays;
  std::vector<std::string> left_out;  ///< a line for each: "array 'stress' (9 components) is not
                                      ///< kept in .glb"
};

/// The part of `arrays` that the file `path` can hold, by its extension:
/// .vtp         everything; names are as they are, but for characters that XML has not;
/// .ply         everything but 64-bit numbers that are neither 32-bit ones nor a double exactly;
///              arrays of cells are properties of faces. Names are one word: other characters than
///              letters, digits and underscores become underscores;
/// .gltf .glb   arrays of points with 1 to 4 components of finite numbers that are 32-bit floats
///              exactly; names are in capitals after an underscore;
/// .obj         "normal" and "uv" of points;
/// .csv         everything, for lines and samples.
/// Names that are the same then, or taken, get underscores at their end. What was fitted fits: it
/// stays as it is. Numbers of components are 1 or more.
FittedArrays fitted_arrays(const std::filesystem::path& path, DataArrays arrays);

struct LoadedMesh {
  Mesh mesh;
  MeshRepair repair;  ///< defects of the file's mesh
  /// For every vertex of the file, in its order, the vertex that triangles use in its place:
  /// itself, or the first at the same place. Empty if nothing was joined.
  std::vector<Index> vertex_of_row;
  /// Arrays of the file, with a row per vertex of `mesh` and per triangle.
  DataArrays arrays = {};
  bool renumbered = false;  ///< joined vertices were removed, and the others have new numbers
  /// Lines for the user on parts of the file that are missing here.
  std::string left_out = {};
};

/// Reads VTP, VTU, legacy VTK, PLY, OBJ, OFF, STL, glTF and GLB, told apart by the path's
/// extension; polygons are cut into triangles, and all objects of the file become one mesh. Arrays
/// of numbers in files of VTK, properties of PLY and attributes of glTF come with it, of the types
/// that they have there. `left_out` lists the rest of the file. The mesh of a file of VTK with
/// volume cells alone is their boundary: the faces that belong to one cell only.
///
/// Vertices of VTK, OBJ, PLY and OFF files keep their numbers, so that data per vertex match,
/// whether or not a triangle uses them. In every format, triangles use the first of all vertices
/// that stand at exactly one place: files often repeat vertices along seams of texture, or for
/// every triangle. The others stay behind unreferenced; in an STL file, which has no numbers, they
/// are removed. Coordinates that are large against the mesh's size are made relative to
/// `Mesh::origin`.
///
/// Throws Error, naming the file, the line where there is one, and the remedy, for a path that
/// cannot be read, an unknown extension, a damaged file, or a file without a usable triangle; and
/// Cancelled if `progress`, which reports the share of the file that is read, asks for it.
LoadedMesh read_mesh(const std::filesystem::path& path, const Progress& progress = {});

/// The files that `read_mesh` reads besides a .gltf; empty if that cannot be read.
std::vector<std::filesystem::path> gltf_buffer_files(const std::filesystem::path& gltf);

/// The vertices that `read_mesh` reads, of a file with or without triangles. Coordinates that are
/// no numbers stay so. Throws Error as `read_mesh` does.
Mesh read_vertices(const std::filesystem::path& path);

/// Writes OBJ, PLY (binary), VTP, glTF or GLB by the path's extension, whole or not at all, with
/// arrays of a row per vertex and per triangle (`fitted_arrays`).
/// Throws Error for an unknown extension, for arrays that the format cannot hold or that have
/// another number of rows, and what write_file throws; Cancelled if `progress` asks for it, which
/// leaves what stood at the path.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh,
                std::span<const DataArray> point_arrays = {},
                std::span<const DataArray> cell_arrays = {}, const Progress& progress = {});

/// Writes a mesh that shows a picture at its texture coordinates, which repeats beyond its borders.
/// `point_arrays` have "uv"; `png` is a PNG file's content. glTF and GLB hold the picture; for
/// others it is written beside the mesh, for OBJ with a material library: `textured_mesh_files`.
/// Throws Error as `write_mesh` does, and if "uv" is missing.
void write_textured_mesh(const std::filesystem::path& path, const Mesh& mesh,
                         std::span<const DataArray> point_arrays, const std::string& png,
                         std::span<const DataArray> cell_arrays = {},
                         const Progress& progress = {});

/// All files that `write_textured_mesh` writes for `path`, that itself last. Throws Error if the
/// mesh would name a file beside it whose name has control characters, such as line breaks.
std::vector<std::filesystem::path> textured_mesh_files(const std::filesystem::path& path);

/// A file of a mesh or of points, which is read once: if it had to be read to find out whether it
/// has faces, the result is kept until the mesh or the points are taken.
class SurfaceFile {
 public:
  /// Reads nothing.
  explicit SurfaceFile(std::filesystem::path path);
  ~SurfaceFile();
  SurfaceFile(SurfaceFile&&) noexcept;
  SurfaceFile& operator=(SurfaceFile&&) noexcept;

  const std::filesystem::path& path() const;

  /// False for .csv, and for .vtp, .vtu, .vtk, .ply and .obj without faces (and without volume
  /// cells, whose boundary are faces). True if the file cannot be read: `mesh` throws the reason.
  /// Throws Cancelled if `progress` asks for it.
  bool has_faces(const Progress& progress = {});

  /// Whether the file is to be read as points unless somebody chose: it has no faces. Throws Error,
  /// with the remedy, for a file of lines without faces, whose points are on curves and not all
  /// over a surface; and Cancelled if `progress` asks for it.
  bool is_point_cloud(const Progress& progress = {});

  /// What `read_mesh` returns, and throws.
  LoadedMesh mesh(const Progress& progress = {});

  /// What `read_points` returns, and throws; and Cancelled if `progress` asks for it.
  LoadedPoints points(const Progress& progress = {});

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Whether a file holds points and no faces: .csv, and .vtp, .vtu, .vtk, .ply and .obj without
/// faces (and without volume cells, whose boundary are faces). False if the file cannot be
/// read: `read_mesh` throws the reason. Use a `SurfaceFile` to read it next.
bool is_point_file(const std::filesystem::path& path);

/// Reads points, and normals if there are as many, from
/// - CSV: rows of x,y,z or x,y,z,nx,ny,nz; or, where the first row names columns, those called
///   Points:0 to Points:2, or x, y and z, and Normals:0 to Normals:2, or nx, ny and nz. The others
///   are arrays, as `read_csv_arrays` makes them;
/// - PLY, OBJ and VTK's files: the vertices, whether or not there are faces, with their arrays;
/// - any other mesh file: the vertices, without normals.
/// Throws Error naming the file, the line where there is one, and the remedy for a file that cannot
/// be read or has no point with finite coordinates.
LoadedPoints read_points(const std::filesystem::path& path);

/// Lines of one kind, with a name: letters, digits and underscores.
struct NamedLines {
  std::string name;
  const Polylines& lines;
  std::vector<DataArray> arrays = {};  ///< a row per point
};

/// Whether `write_polylines` knows the path's extension.
bool is_polyline_format(const std::filesystem::path& path);

/// Writes by the path's extension, whole or not at all:
/// .obj  points, and lines (`l`) in a group per kind;
/// .ply  binary: points with normals, the number of their line and of its kind, and edges;
/// .vtp  lines, with the number of their kind, whether they are closed and their length;
/// .csv  a row per point: kind, line, closed, x, y, z, nx, ny, nz.
/// A closed line comes back to its first point, which is not repeated but in .vtp and .obj's lists.
/// All but .obj hold the arrays too, which are the same of all kinds but for their numbers; in .ply
/// and .csv they are columns, NAME or, of three components, NAME_x, NAME_y, NAME_z, of other
/// numbers of them NAME_0 and so on. Names that are taken get underscores at their end.
/// Throws Error for another extension, for more points than an Index can count, for arrays with
/// other numbers of rows or that differ between kinds or do not fit (`fitted_arrays`), and what
/// write_file throws.
void write_polylines(const std::filesystem::path& path, std::span<const NamedLines> kinds,
                     const Progress& progress = {});

/// Whether `write_samples` knows the path's extension.
bool is_sample_format(const std::filesystem::path& path);

/// Writes all that a Sample has, whole or not at all, by the path's extension: .csv a row per
/// sample, .ply (binary) a vertex per sample, .vtp a point per sample; and `arrays` of a row per
/// sample, as `write_polylines` does. Positions are relative to `origin`, which is that of the
/// mesh, and written where they stand. Throws Error for another extension, for arrays as
/// `write_polylines` does, and what write_file throws.
void write_samples(const std::filesystem::path& path, std::span<const Sample> samples,
                   const Eigen::Vector3d& origin = Eigen::Vector3d::Zero(),
                   std::span<const DataArray> arrays = {}, const Progress& progress = {});

/// The columns of a CSV file whose first row names them, as arrays of float64 with a row each.
/// Commas, semicolons, tabs or spaces part the columns, and cells may stand in quotation marks;
/// empty cells are NaN, and columns of words are left out. Columns NAME:0 to NAME:k-1 (so
/// ParaView writes them), NAME_0 to NAME_k-1, or NAME with :x, :y, :z or _x, _y, _z, in any order,
/// become one array NAME; so do xx, yy, zz, xy, yz, xz, and xx, xy, xz, yx and so on to zz. Throws
/// Error naming the file, the line, the column and the remedy if the file cannot be read or does
/// not name its columns, a word stands in a column of numbers, or a row has more or fewer cells
/// than there are names.
std::vector<DataArray> read_csv_arrays(const std::filesystem::path& path);

/// The same from the first row alone: every array has one row, with the numbers of its columns,
/// counted from 0. Columns of words have not been left out.
std::vector<DataArray> csv_columns(const std::filesystem::path& path);

/// The rows of a field file, one per vertex.
struct FieldFile {
  std::vector<Vec3> vectors;
  std::vector<float> frequencies;    ///< stripes per unit length; empty if the file has 3 columns
  std::vector<float> frequencies_v;  ///< of the crossing stripes; empty below 5 columns
};

/// Reads a CSV file (`read_csv_arrays`) of 3 columns x,y,z, 4 with the frequency, or 5 with the
/// frequency of the stripes that cross the others where a texture is laid along both. Of a file
/// whose first row names columns x, y and z, these and, if there are such names, `frequency` and
/// `frequency_v` are taken wherever they stand; unless x,y,z come first, of five columns or fewer,
/// and the others have other names: then these are the frequencies. `nan` is a value: no wave here.
/// The length of vectors does not matter.
///
/// A row stands for a vertex of the mesh or, if there are as many rows as entries in
/// `vertex_of_row`, for a vertex of the mesh's file (`LoadedMesh`). Several rows of one vertex
/// are averaged: directions up to sign, and frequencies.
/// Throws Error naming the file, the line and the remedy if the file cannot be read, a row has
/// another number of columns or a word in it, a frequency is not above zero, or the number of rows
/// is neither of both.
FieldFile read_field_csv(const std::filesystem::path& path, std::size_t vertex_count,
                         std::span<const Index> vertex_of_row = {});

/// Reads a CSV file of one number from 0 to 1 a row, or with a column of the name `calm`: the
/// weight of branch avoidance (`Slack::calm`). Rows are assigned to vertices as in
/// `read_field_csv`; the greatest of several rows of one vertex is used. Throws Error as that does.
std::vector<float> read_calm_csv(const std::filesystem::path& path, std::size_t vertex_count,
                                 std::span<const Index> vertex_of_row = {});

/// Reads strokes from JSON, with these keys and no others:
///
///     {"strokes": [
///       {"radius": 0.1, "strength": 2, "points": [[0, 0, 1], [0.5, 0, 0.9]]}
///     ]}
///
/// `strength` is 1 where it is missing. Throws Error naming the file and the place in it, by line
/// and column where the JSON is damaged and as `strokes[2].points[5]` elsewhere, for a file that
/// cannot be read, other keys, other types, no strokes, strokes that `check_strokes` refuses, and
/// in a build without nlohmann-json.
std::vector<FieldStroke> read_strokes(const std::filesystem::path& path);

/// Writes strokes for `read_strokes`, whole or not at all; what is read and written again has the
/// same bytes. Throws Error as `check_strokes` does, and what write_file throws.
void write_strokes(const std::filesystem::path& path, std::span<const FieldStroke> strokes);

}  // namespace brindle
