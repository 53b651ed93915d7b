#include "brindle/files.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "job.h"
#include "pattern_data.h"

namespace brindle::python {
namespace {

Mesh mesh_of(const py::tuple& origin, py::handle vertices, py::handle triangles) {
  const Table positions = table_of(vertices, "vertices");
  const Table corners = table_of(triangles, "triangles");
  Mesh mesh = make_mesh(positions.view, corners.view, BadTriangles::kept);
  for (int axis = 0; axis < 3; ++axis) mesh.origin[axis] += py::cast<double>(origin[axis]);
  return mesh;
}

// What the file holds of the arrays, and lines about what it does not.
std::vector<std::string> write(const std::string& path, const Mesh& mesh, const py::dict& points,
                               const py::dict& cells, const std::string& png) {
  DataArrays arrays{data_arrays_of(points), data_arrays_of(cells)};
  return without_lock([&] {
    FittedArrays fitted = fitted_arrays(path, std::move(arrays));
    if (png.empty()) {
      write_mesh(path, mesh, fitted.arrays.points, fitted.arrays.cells);
    } else {
      write_textured_mesh(path, mesh, fitted.arrays.points, png, fitted.arrays.cells);
    }
    return fitted.left_out;
  });
}

}  // namespace

void bind_files(py::module_& module) {
  module.def(
      "write_surface",
      [](const std::string& path, const SurfaceData& surface, const py::dict& points,
         const py::dict& cells) { return write(path, surface.surface.mesh, points, cells, ""); },
      py::arg("path"), py::arg("surface"), py::arg("point_data"), py::arg("cell_data"));
  module.def(
      "write_mesh",
      [](const std::string& path, const py::tuple& origin, py::handle vertices,
         py::handle triangles, const py::dict& points, const py::dict& cells,
         const py::bytes& png) {
        return write(path, mesh_of(origin, vertices, triangles), points, cells, png);
      },
      py::arg("path"), py::arg("origin"), py::arg("vertices"), py::arg("triangles"),
      py::arg("point_data"), py::arg("cell_data"), py::arg("png"));
}

}  // namespace brindle::python
