/// Content and camera of pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "brindle/renderer.h"
#include "pattern_data.h"

namespace brindle::python {

namespace py = pybind11;

/// Options of pictures and drawings, as Python sets them.
struct Picture {
  RenderOptions options;
  std::optional<Slice> slice;    ///< in surface coordinates
  std::string view = "stripes";  ///< or branches, angle_error
  bool own_colors = false;       ///< colours were given
};

/// The options with the slice, of surfaces relative to `origin`.
RenderOptions options_relative_to(const Eigen::Vector3d& origin, const Picture& picture);

/// Throws Error if the slice removes the whole mesh of a picture.
void check_slice_leaves_something(const Mesh& mesh, const RenderOptions& options);

/// The colour of lines: the picture's own for stripes, or the standard one.
Color line_color(const Picture& picture, const std::string& standard);

// Of builds with OpenGL.

/// A built-in tile by name, or an array of pixels.
TextureTile tile_of(py::handle tile);

/// Empty if tiles are cut, by request or as the tile's default.
std::optional<BrokenTiles> broken_tiles_of(const TextureData& texture, const TextureTile& tile,
                                           std::optional<bool> whole);

void bind_relief(py::module_& module);
void bind_renderer(py::module_& module);

}  // namespace brindle::python
