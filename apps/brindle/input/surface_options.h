/// The mesh of a command.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "brindle/creases.h"
#include "brindle/files.h"

namespace brindle::tool {

/// Faces of a closed solid that paths leave out: its bottom and its top.
struct Lids {
  std::optional<float> degrees;  ///< from level, instead of a file
  std::string file;              ///< .csv: a number per triangle of the mesh's file; lids have 1
  Vec3 up = Vec3::UnitZ();
};

/// "30" or "lids.csv". Throws CLI::ValidationError for other text.
Lids parse_lids(const std::string& option, const std::string& text);

/// Removes the triangles of lids. Throws Error if the file does not fit, and unless some triangles
/// are lids and some are not.
void leave_out(const Lids& lids, LoadedMesh& loaded);

constexpr int kDefaultNeighbors = 8;

struct SurfaceOptions {
  std::string mesh;                        ///< a file or shape:NAME,...
  int subdivide = 0;                       ///< subdivisions of every triangle into four
  bool rounded = false;                    ///< subdivision bends triangles (`Midpoints`)
  std::optional<float> crease_angle = {};  ///< degrees, instead of `kCreaseAngle`
  bool points = false;                     ///< the vertices only
  std::optional<int> neighbors = {};       ///< per point, instead of `kDefaultNeighbors`
  Vec3 moved = Vec3::Zero();               ///< translation after reading
  std::optional<Lids> lids = {};           ///< left out after reading
  /// The mesh's file, as far as `is_points` had to read it.
  mutable std::shared_ptr<SurfaceFile> file = {};

  /// Calls `add("--option", field)` for the options of commands that accept points.
  template <class Add>
  void visit_points(const Add& add) {
    add("--points", points);
    add("--neighbors", neighbors);
  }
};

void add_surface_options(CLI::App& app, SurfaceOptions& options);

/// --points and --neighbors.
void add_point_options(CLI::App& app, SurfaceOptions& options);

/// Whether the command works on points without triangles, by option or because the file has no
/// faces.
bool is_points(const SurfaceOptions& options);

/// Throws Error for points in a command that needs triangles. `command` is its name.
void refuse_points(const SurfaceOptions& options, const std::string& command);

/// A line for the user if a file without faces is read as points; else empty.
std::string describe_kind(const SurfaceOptions& options);

/// Lines about recentring and repairs; may be empty.
std::string describe(const LoadedPoints& loaded);
std::string describe(const LoadedMesh& loaded);

/// Reads the points of a file or takes the vertices of a shape. Throws as `load_mesh` does.
LoadedPoints load_points(const SurfaceOptions& options);

/// Whether the mesh is a built-in shape.
bool is_shape(const SurfaceOptions& options);

/// The text after "shape:".
std::string_view shape_spec(const SurfaceOptions& options);

/// A loaded mesh.
struct LoadedSurface : LoadedMesh {
  std::size_t own_vertices = 0;  ///< of the file or shape, before those of --subdivide
};

/// Reads or makes the mesh and subdivides it. Throws CLI::ValidationError for a misspelt shape and
/// for --neighbors, Error if a file cannot be read.
LoadedSurface load_mesh(const SurfaceOptions& options, const Progress& progress = {});

/// Splits the loaded mesh and its arrays at creases.
Creases split_at_creases(const SurfaceOptions& options, LoadedSurface& loaded);

}  // namespace brindle::tool
