/// A surface and what came with it.
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

/// Python hands these around; nobody changes one.
struct SurfaceData {
  Surface surface;
  std::string name;  ///< a file, a shape, or "arrays"
  MeshRepair repair;
  std::optional<PointRepair> point_repair;  ///< of points
  DataArrays arrays;                        ///< a row per vertex, and per triangle
  std::string left_out;                     ///< lines about what the file has and this has not
  std::vector<Index> vertex_of_row;         ///< `LoadedMesh::vertex_of_row`
  /// For every vertex, up to the last that was joined with another, the one that triangles use in
  /// its place, whose wave it gets; empty if there are none.
  std::vector<Index> partners;
  std::vector<std::int64_t> original_ids;  ///< numbers in the file or array; -1 of added vertices
  std::vector<Index> kept_triangles;       ///< their numbers before repair; empty if all were kept
  std::size_t vertices_joined = 0;
  float crease_angle = 180;  ///< of the creases that have split the surface
  double load_milliseconds = 0;
  double topology_milliseconds = 0;

  bool is_points() const { return surface.mesh.triangles.empty(); }
};

using SurfacePointer = std::shared_ptr<SurfaceData>;

/// Whether vertices of `mesh` are those of `last` with the same number: `match` is "number",
/// "position", or empty for number where the triangles are the same. Throws Error for other words.
bool matches_by_number(const Mesh& last, const Mesh& mesh, const std::string& match);

void bind_surfaces(py::module_& module);
void bind_fields(py::module_& module);

}  // namespace brindle::python
