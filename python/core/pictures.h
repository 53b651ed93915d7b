/// What a picture shows, and from where.
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
  std::optional<Slice> slice;    ///< in the surface's own coordinates
  std::string view = "stripes";  ///< or branches, angle_error
};

/// The options with the slice, of surfaces relative to `origin`.
RenderOptions options_relative_to(const Eigen::Vector3d& origin, const Picture& picture);

/// Throws Error if the slice takes away all of a mesh that a picture shows alone.
void check_slice_leaves_something(const Mesh& mesh, const RenderOptions& options);

/// A mesh of one colour on the surface: tubes along curves, discs at samples.
struct Ornament {
  Mesh mesh;
  Color color;
};

/// Defined where there is OpenGL, and where there is none: then the functions throw Error.
void bind_renderer(py::module_& module);

}  // namespace brindle::python
