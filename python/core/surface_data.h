/// A surface and its source data.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "brindle/data_arrays.h"
#include "brindle/mesh.h"
#include "brindle/points.h"
#include "brindle/surface.h"

namespace brindle::python {

namespace py = pybind11;

/// Shared by Python objects; immutable.
struct SurfaceData {
  Surface surface;
  std::string name;  ///< a file, a shape, or "arrays"
  MeshRepair repair;
  std::optional<PointRepair> point_repair;  ///< of points
  DataArrays arrays;                        ///< per vertex and per triangle
  std::string left_out;                     ///< lines about left-out parts of the file
  std::vector<Index> vertex_of_row;         ///< `LoadedMesh::vertex_of_row`
  /// For every vertex, up to the last joined one, the vertex that replaces it, whose wave it gets;
  /// empty without joined vertices.
  std::vector<Index> partners;
  std::vector<std::int64_t> original_ids;  ///< numbers in the file or array; -1 of added vertices
  std::size_t vertices_joined = 0;
  float crease_angle = 180;  ///< of the creases that split the surface
  double load_milliseconds = 0;
  double topology_milliseconds = 0;

  bool is_points() const { return surface.mesh.triangles.empty(); }
};

using SurfacePointer = std::shared_ptr<SurfaceData>;

/// Whether vertices of `mesh` correspond by number to those of `last`: `match` is "number",
/// "position", or empty (number if the triangles are the same). Throws Error for other words.
bool matches_by_number(const Mesh& last, const Mesh& mesh, const std::string& match);

void bind_surfaces(py::module_& module);
void bind_fields(py::module_& module);

}  // namespace brindle::python
