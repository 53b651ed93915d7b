/// The mesh that a command works on.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "brindle/surface/mesh_io.h"

namespace brindle::tool {

struct SurfaceOptions {
  std::string mesh;   ///< a file or shape:NAME,...
  int subdivide = 0;  ///< how often every triangle is split in four
};

void add_surface_options(CLI::App& app, SurfaceOptions& options);

/// Whether the mesh is a built-in shape.
bool is_shape(const SurfaceOptions& options);

/// Reads or makes the mesh and subdivides it. Throws CLI::ValidationError for a shape that is not
/// spelt right, Error if a file cannot be read.
LoadedMesh load_mesh(const SurfaceOptions& options);

}  // namespace brindle::tool
