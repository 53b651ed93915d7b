#include "brindle/files.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/pattern_arrays.h"
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

DataArrays arrays_of(const py::dict& points, const py::dict& cells) {
  return {data_arrays_of(points), data_arrays_of(cells)};
}

// The arrays that the file can hold, with those of an input, and lines about left-out and renamed
// ones.
std::vector<std::string> write(const std::string& path, const Mesh& mesh, DataArrays arrays,
                               const DataArrays& input, const std::string& png) {
  return without_lock([&] {
    std::vector<std::string> notes;
    FittedArrays fitted = fitted_arrays(path, join_arrays(std::move(arrays), input, notes));
    if (png.empty()) {
      write_mesh(path, mesh, fitted.arrays.points, fitted.arrays.cells);
    } else {
      write_textured_mesh(path, mesh, fitted.arrays.points, png, fitted.arrays.cells);
    }
    notes.insert(notes.end(), fitted.left_out.begin(), fitted.left_out.end());
    return notes;
  });
}

}  // namespace

void bind_files(py::module_& module) {
  module.def(
      "write_surface",
      [](const std::string& path, const SurfaceData& surface, const py::dict& points,
         const py::dict& cells, const py::dict& input_points, const py::dict& input_cells) {
        return write(path, surface.surface.mesh, arrays_of(points, cells),
                     arrays_of(input_points, input_cells), "");
      },
      py::arg("path"), py::arg("surface"), py::arg("point_data"), py::arg("cell_data"),
      py::arg("input_point_data"), py::arg("input_cell_data"));
  module.def(
      "write_mesh",
      [](const std::string& path, const py::tuple& origin, py::handle vertices,
         py::handle triangles, const py::dict& points, const py::dict& cells,
         const py::bytes& png) {
        return write(path, mesh_of(origin, vertices, triangles), arrays_of(points, cells), {}, png);
      },
      py::arg("path"), py::arg("origin"), py::arg("vertices"), py::arg("triangles"),
      py::arg("point_data"), py::arg("cell_data"), py::arg("png"));
}

}  // namespace brindle::python
