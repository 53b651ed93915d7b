/// Content and camera of pictures.
#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "brindle/renderer.h"

namespace brindle::python {

namespace py = pybind11;

/// Options of pictures and drawings, as Python sets them.
struct Picture {
  RenderOptions options;
  std::optional<Slice> slice;    ///< in surface coordinates
  std::string view = "stripes";  ///< or branches, angle_error
};

/// The options with the slice, of surfaces relative to `origin`.
RenderOptions options_relative_to(const Eigen::Vector3d& origin, const Picture& picture);

/// Throws Error if the slice removes the whole mesh of a picture.
void check_slice_leaves_something(const Mesh& mesh, const RenderOptions& options);

/// A single-coloured mesh on the surface: tubes along curves, discs at samples.
struct Ornament {
  Mesh mesh;
  Color color;
};

/// In builds without OpenGL, the functions throw Error.
void bind_renderer(py::module_& module);

}  // namespace brindle::python
