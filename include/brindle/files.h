/// Readers and writers of meshes, points, lines, samples and strokes.
#pragma once

#include <cstdint>
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

struct Machine;
struct ToolPaths;

/// Arrays that formats store in their own way: "normal" (unit vectors) of 3 floating-point numbers;
/// "color" (red, green, blue) of 3, floating-point from 0 to 1 or uint8 from 0 to 255; "uv"
/// (texture coordinates in sides of the picture, from its lower left corner to the right and up) of
/// 2 floating-point numbers.
bool is_normal(const DataArray& array);
bool is_color(const DataArray& array);
bool is_uv(const DataArray& array);

/// Arrays in the form that a file can hold.
struct FittedArrays {
  DataArrays arrays;
  /// One line each: "array 'stress' (9 components) is not kept in .glb".
  std::vector<std::string> left_out;
};

/// The part of `arrays` that the file `path` can hold, by its extension:
/// .vtp         everything; names stay, except for characters that XML lacks;
/// .ply         everything except 64-bit numbers that neither 32-bit integers nor doubles hold
///              exactly; arrays of cells become properties of faces. In names, characters other
///              than letters, digits and underscores become underscores;
/// .gltf .glb   arrays of points with 1 to 4 components of finite numbers that 32-bit floats hold
///              exactly; names are in capitals after an underscore;
/// .obj         "normal" and "uv" of points;
/// .stl .3mf    nothing;
/// .csv         everything, for lines and samples.
/// Names that are then equal, or taken, get underscores at their end. Fitted arrays do not change
/// when fitted again. Numbers of components are 1 or more.
FittedArrays fitted_arrays(const std::filesystem::path& path, DataArrays arrays);

/// A mesh read from a file.
struct LoadedMesh {
  Mesh mesh;
  MeshRepair repair;  ///< defects of the file's mesh
  /// For every vertex of the file, in its order, the vertex that triangles use in its place:
  /// itself, or the first at the same position. Empty if nothing was joined.
  std::vector<Index> vertex_of_row;
  /// Arrays of the file, with a row per vertex of `mesh` and per triangle.
  DataArrays arrays = {};
  bool renumbered = false;  ///< joined vertices were removed, and the others have new numbers
  /// Lines for the user on parts of the file that were not read.
  std::string left_out = {};
};

/// Reads VTP, VTU, legacy VTK, PLY, OBJ, OFF, STL, glTF and GLB, by the path's extension. Polygons
/// are cut into triangles, and all objects of the file become one mesh. Numeric arrays of VTK
/// files, properties of PLY and attributes of glTF keep their types. `left_out` lists the rest of
/// the file. A VTK file with only volume cells gives their boundary: faces of exactly one cell.
///
/// Vertices of VTK, OBJ, PLY and OFF files keep their numbers, used or not, so that data per vertex
/// match. Files often repeat vertices along texture seams or for every triangle. In every format,
/// triangles therefore use the first of all vertices at exactly one position. The others stay
/// unreferenced; in STL files, which have no numbers, they are removed. Coordinates that are large
/// against the mesh's size are made relative to `Mesh::origin`.
///
/// Throws Error, naming the file, the line where there is one, and the remedy, for a path that
/// cannot be read, an unknown extension, a damaged file, or a file without a usable triangle.
/// Throws Cancelled if `progress` cancels, which reports the share of the file that was read.
LoadedMesh read_mesh(const std::filesystem::path& path, const Progress& progress = {});

/// Cells over points, as VTK holds them in memory.
struct CellArrays {
  DataArray points;                 ///< three coordinates per point
  DataArray corners;                ///< numbers of points, cell after cell
  DataArray ends;                   ///< per cell the end of its corners
  std::vector<std::uint8_t> types;  ///< per cell, VTK's numbers of cell types
  DataArrays arrays = {};           ///< a row per point and per cell
};

/// The surface that `read_mesh` makes of a VTK file with these cells. Throws Error as it does, with
/// `name` in place of the path.
LoadedMesh mesh_of_cells(CellArrays cells, const std::string& name);

/// The files that `read_mesh` reads besides a .gltf; empty if the .gltf cannot be read.
std::vector<std::filesystem::path> gltf_buffer_files(const std::filesystem::path& gltf);

/// The vertices that `read_mesh` reads, from a file with or without triangles. Coordinates that are
/// no numbers are kept. Throws Error as `read_mesh` does.
Mesh read_vertices(const std::filesystem::path& path);

/// Writes OBJ, PLY (binary), VTP, glTF, GLB, STL (binary) or 3MF (in millimetres) by the path's
/// extension, whole or not at all, with
/// arrays of a row per vertex and per triangle (`fitted_arrays`). Throws Error for an unknown
/// extension, for arrays that the format cannot hold or that have another number of rows, and what
/// write_file throws. Throws Cancelled if `progress` cancels, and then keeps an existing file.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh,
                std::span<const DataArray> point_arrays = {},
                std::span<const DataArray> cell_arrays = {}, const Progress& progress = {});

/// Writes a mesh that shows a picture, repeated, at its texture coordinates. `point_arrays` have
/// "uv"; `png` is a PNG file's content. glTF and GLB hold the picture. For other formats it is
/// written beside the mesh, for OBJ with a material library: `textured_mesh_files`. Throws Error as
/// `write_mesh` does, and if "uv" is missing.
void write_textured_mesh(const std::filesystem::path& path, const Mesh& mesh,
                         std::span<const DataArray> point_arrays, const std::string& png,
                         std::span<const DataArray> cell_arrays = {},
                         const Progress& progress = {});

/// All files that `write_textured_mesh` writes for `path`, itself last. Throws Error if the mesh
/// would refer to a file name with control characters, such as line breaks.
std::vector<std::filesystem::path> textured_mesh_files(const std::filesystem::path& path);

/// A file of a mesh or of points that is read only once. A check for faces that has to read the
/// file keeps the result until the mesh or the points are taken.
class SurfaceFile {
 public:
  /// Reads nothing.
  explicit SurfaceFile(std::filesystem::path path);
  ~SurfaceFile();
  SurfaceFile(SurfaceFile&&) noexcept;
  SurfaceFile& operator=(SurfaceFile&&) noexcept;

  const std::filesystem::path& path() const;

  /// False for .csv, and for .vtp, .vtu, .vtk, .ply and .obj without faces (and without volume
  /// cells, whose boundary has faces). True if the file cannot be read; then `mesh` throws the
  /// reason. Throws Cancelled if `progress` cancels.
  bool has_faces(const Progress& progress = {});

  /// Whether the file is read as points by default: it has no faces. Throws Error, with the remedy,
  /// for a file of lines without faces, whose points lie on curves rather than over a surface; and
  /// Cancelled if `progress` cancels.
  bool is_point_cloud(const Progress& progress = {});

  /// Returns and throws what `read_mesh` does.
  LoadedMesh mesh(const Progress& progress = {});

  /// Returns and throws what `read_points` does; also Cancelled if `progress` cancels.
  LoadedPoints points(const Progress& progress = {});

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Whether a file holds points and no faces: .csv, and .vtp, .vtu, .vtk, .ply and .obj without
/// faces (and without volume cells, whose boundary has faces). False if the file cannot be read;
/// then `read_mesh` throws the reason. Use a `SurfaceFile` to read it next.
bool is_point_file(const std::filesystem::path& path);

/// Reads points, and normals if there are as many, from
/// - CSV: rows of x,y,z or x,y,z,nx,ny,nz. If the first row names columns: Points:0 to Points:2, or
///   x, y and z; and Normals:0 to Normals:2, or nx, ny and nz. The others become arrays
///   (`read_csv_arrays`);
/// - PLY, OBJ and VTK files: the vertices, with or without faces, and their arrays;
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

/// Whether `write_polylines` supports the path's extension.
bool is_polyline_format(const std::filesystem::path& path);

/// Writes by the path's extension, whole or not at all:
/// .obj  points, and lines (`l`) in a group per kind;
/// .ply  binary: points with normals, the numbers of their line and kind, and edges;
/// .vtp  lines, with the number of their kind, whether they are closed and their length;
/// .csv  a row per point: kind, line, closed, x, y, z, nx, ny, nz.
/// Closed lines repeat their first point only in .vtp and in the lists of .obj.
/// All formats but .obj hold the arrays too, which must agree between kinds except for their
/// numbers. In .ply and .csv they are columns: NAME; for three components NAME_x, NAME_y, NAME_z;
/// for others NAME_0 and so on. Names that are taken get underscores at their end. Throws Error for
/// another extension, for more points than an Index can count, for arrays with other numbers of
/// rows or that differ between kinds or do not fit (`fitted_arrays`), and what write_file throws.
void write_polylines(const std::filesystem::path& path, std::span<const NamedLines> kinds,
                     const Progress& progress = {});

/// Whether `write_tool_paths` supports the path's extension.
bool is_tool_path_format(const std::filesystem::path& path);

/// Writes paths by the path's extension, whole or not at all:
/// .csv .vtp .ply .obj  as `write_polylines`, in the mesh's units, with arrays: direction, width,
///                      speed, extrusion (width over nominal width), join, cut, and the pose
///                      qw, qx, qy, qz (`path_poses`);
/// .dxf                 a 3D polyline per path (R12), in millimetres of the machine;
/// .gcode               G0 and G1 in millimetres, absolute (G21, G90), F in millimetres a minute,
///                      with E for printers; cuts are comments. With 5 axes, X, Y and Z are the
///                      tool's tip on the part (G43.4), and its axis is Rz(C) Rx(A) z.
/// Throws Error for another extension, what `machine_points` throws, and what write_file throws.
void write_tool_paths(const std::filesystem::path& path, const ToolPaths& paths,
                      const Machine& machine, const Progress& progress = {});

/// Whether `write_samples` supports the path's extension.
bool is_sample_format(const std::filesystem::path& path);

/// Writes all members of a Sample, whole or not at all, by the path's extension: .csv a row per
/// sample, .ply (binary) a vertex per sample, .vtp a point per sample. `arrays` have a row per
/// sample and are written as in `write_polylines`. Positions are relative to the mesh's `origin`;
/// files get absolute ones. Throws Error for another extension, for arrays as `write_polylines`
/// does, and what write_file throws.
void write_samples(const std::filesystem::path& path, std::span<const Sample> samples,
                   const Eigen::Vector3d& origin = Eigen::Vector3d::Zero(),
                   std::span<const DataArray> arrays = {}, const Progress& progress = {});

/// The columns of a CSV file whose first row names them, as arrays of float64. Commas, semicolons,
/// tabs or spaces separate columns, and cells may be quoted. Empty cells are NaN; columns of words
/// are left out. Columns NAME:0 to NAME:k-1 (as ParaView writes them), NAME_0 to NAME_k-1, or NAME
/// with :x, :y, :z, or _x, _y, _z, or x, y, z (vx, vy, vz), in any order, become one array NAME; so
/// do xx, yy, zz, xy, yz, xz, and xx, xy, xz, yx and so on to zz, behind a colon or underscore.
/// Throws Error naming the file, the line, the column and the remedy if the file cannot be read or
/// does not name its columns, a column of numbers contains a word, or a row has more or fewer cells
/// than there are names.
std::vector<DataArray> read_csv_arrays(const std::filesystem::path& path);

/// As above from the first row alone: every array has one row, with the numbers of its columns,
/// counted from 0. Columns of words are included.
std::vector<DataArray> csv_columns(const std::filesystem::path& path);

/// The rows of a field file, one per vertex.
struct FieldFile {
  std::vector<Vec3> vectors;
  std::vector<float> frequencies;    ///< stripes per unit length; empty if the file has 3 columns
  std::vector<float> frequencies_v;  ///< of V, the crossing stripes; empty below 5 columns
};

/// Reads a CSV file (`read_csv_arrays`) of 3 columns x,y,z, 4 with the frequency, or 5 with the
/// frequency of V, the crossing stripes of a texture. If the first row names columns x, y and z,
/// these and any `frequency` and `frequency_v` are found by name. In files of at most five columns
/// that begin with x,y,z, the others may have any names. `nan` is valid: no wave here. The length
/// of vectors does not matter.
///
/// A row belongs to a vertex of the mesh or, if there are as many rows as entries in
/// `vertex_of_row`, to a vertex of the mesh's file (`LoadedMesh`). Several rows of one vertex are
/// averaged: directions up to sign, and frequencies. Throws Error naming the file, the line and the
/// remedy if the file cannot be read, a row has another number of columns or a word, a frequency is
/// not above zero, or the number of rows matches neither.
FieldFile read_field_csv(const std::filesystem::path& path, std::size_t vertex_count,
                         std::span<const Index> vertex_of_row = {});

/// Reads a CSV file of one number from 0 to 1 per row, or with a column `avoid_branches`: the
/// weight of branch avoidance (`Slack::branch_penalty`). Rows are assigned to vertices as in
/// `read_field_csv`; the greatest of several rows of one vertex is used. Throws Error as that does.
std::vector<float> read_branch_penalty_csv(const std::filesystem::path& path,
                                           std::size_t vertex_count,
                                           std::span<const Index> vertex_of_row = {});

/// Reads strokes from JSON, with these keys and no others:
///
///     {"strokes": [
///       {"radius": 0.1, "strength": 2, "points": [[0, 0, 1], [0.5, 0, 0.9]]}
///     ]}
///
/// `strength` defaults to 1. Throws Error naming the file and the place in it, by line and column
/// where the JSON is damaged and as `strokes[2].points[5]` elsewhere, for a file that cannot be
/// read, other keys, other types, no strokes, strokes that `check_strokes` rejects, and in a build
/// without nlohmann-json.
std::vector<FieldStroke> read_strokes(const std::filesystem::path& path);

/// Writes strokes for `read_strokes`, whole or not at all; reading and writing them again gives the
/// same bytes. Throws Error as `check_strokes` does, and what write_file throws.
void write_strokes(const std::filesystem::path& path, std::span<const FieldStroke> strokes);

// Time series of files in ParaView's formats .pvd and .series.

/// A file of a time series.
struct TimedFile {
  double time = 0;
  std::filesystem::path file;
};

/// The files that a .pvd lists, in the order of their times, with paths relative to its folder
/// resolved. Throws Error, naming the file and the remedy, if it cannot be read, is no collection,
/// lists nothing, or more than one file for a time.
std::vector<TimedFile> read_pvd(const std::filesystem::path& path);

/// As above for a .series, a JSON file: {"files": [{"name": "a.vtu", "time": 0.5}, ...]}.
std::vector<TimedFile> read_file_series(const std::filesystem::path& path);

/// Writes a .pvd, whole or not at all, with paths relative to its folder. Throws Error for names
/// that XML cannot hold, and what write_file throws.
void write_pvd(const std::filesystem::path& path, std::span<const TimedFile> files);

}  // namespace brindle
