/// The mesh that a command works on.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "brindle/creases.h"
#include "brindle/files.h"

namespace brindle::tool {

constexpr int kDefaultNeighbors = 8;

struct SurfaceOptions {
  std::string mesh;                        ///< a file or shape:NAME,...
  int subdivide = 0;                       ///< how often every triangle is split in four
  bool rounded = false;                    ///< whether triangles that are split bend (`Midpoints`)
  std::optional<float> crease_angle = {};  ///< degrees, instead of `kCreaseAngle`
  bool points = false;                     ///< the vertices alone
  std::optional<int> neighbors = {};       ///< of a point, instead of `kDefaultNeighbors`
  Vec3 moved = Vec3::Zero();               ///< the mesh, after it was read
  /// The mesh's file, as far as it was read to answer `is_points`.
  mutable std::shared_ptr<SurfaceFile> file = {};

  /// Calls `add("--option", field)` for what commands have that take points.
  template <class Add>
  void visit_points(const Add& add) {
    add("--points", points);
    add("--neighbors", neighbors);
  }
};

void add_surface_options(CLI::App& app, SurfaceOptions& options);

/// --points and --neighbors.
void add_point_options(CLI::App& app, SurfaceOptions& options);

/// Whether the command works on points without triangles: it was asked for, or the file has no
/// others.
bool is_points(const SurfaceOptions& options);

/// Throws Error if a command that cannot work on points should. `command` is what users type.
void refuse_points(const SurfaceOptions& options, const std::string& command);

/// A line for the user if a file is taken for points because it has no faces; otherwise empty.
std::string describe_kind(const SurfaceOptions& options);

/// Lines on what was recentred and repaired; empty if there is nothing to say.
std::string describe(const LoadedPoints& loaded);
std::string describe(const LoadedMesh& loaded);

/// Reads the points of a file or takes the vertices of a shape. Throws as `load_mesh` does.
LoadedPoints load_points(const SurfaceOptions& options);

/// Whether the mesh is a built-in shape.
bool is_shape(const SurfaceOptions& options);

/// What follows "shape:".
std::string_view shape_spec(const SurfaceOptions& options);

/// A mesh that commands work on.
struct LoadedSurface : LoadedMesh {
  std::size_t own_vertices = 0;  ///< of the file or shape; those of --subdivide come after them
};

/// Reads or makes the mesh and subdivides it. Throws CLI::ValidationError for a shape that is not
/// spelt right and for neighbours of points, Error if a file cannot be read.
LoadedSurface load_mesh(const SurfaceOptions& options, const Progress& progress = {});

/// Splits what was loaded, and its arrays, at creases.
Creases split_at_creases(const SurfaceOptions& options, LoadedSurface& loaded);

}  // namespace brindle::tool
