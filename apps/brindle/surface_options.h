/// The mesh that a command works on.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "brindle/files.h"

namespace brindle::tool {

struct SurfaceOptions {
  std::string mesh;     ///< a file or shape:NAME,...
  int subdivide = 0;    ///< how often every triangle is split in four
  bool points = false;  ///< the vertices alone
  int neighbors = 8;    ///< of a point
};

void add_surface_options(CLI::App& app, SurfaceOptions& options);

/// --points and --neighbors.
void add_point_options(CLI::App& app, SurfaceOptions& options);

/// Whether the command works on points without triangles: it was asked for, or the file has no
/// others.
bool is_points(const SurfaceOptions& options);

/// Reads the points of a file or takes the vertices of a shape. Throws as `load_mesh` does.
LoadedPoints load_points(const SurfaceOptions& options);

/// Whether the mesh is a built-in shape.
bool is_shape(const SurfaceOptions& options);

/// Reads or makes the mesh and subdivides it. Throws CLI::ValidationError for a shape that is not
/// spelt right, Error if a file cannot be read.
LoadedMesh load_mesh(const SurfaceOptions& options);

}  // namespace brindle::tool
