#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string_view>

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/base/array_numbers.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/local_positions.h"
#include "brindle/mesh.h"
#include "brindle/mesh_data.h"
#include "brindle/nearest.h"
#include "brindle/normals.h"
#include "brindle/recipe/field_data.h"
#include "brindle/recipe/refusals.h"
#include "brindle/render/parsed_words.h"
#include "brindle/shapes.h"
#include "job.h"
#include "stored.h"
#include "surface_data.h"
#include "words.h"

namespace brindle::python {
namespace {

constexpr std::string_view kShapePrefix = "shape:";
// Shares of progress.
constexpr double kReading = 0.4, kSplit = 0.6;
constexpr std::string_view kSearching = "nearest places";
constexpr std::size_t kPointsBetweenLooks = 1024;  // a tenth of a second, for distant points
constexpr std::size_t kPointsOfTask = 32;
constexpr float kNoCreases = 180;

// The first `own` vertices have numbers; added ones have none.
void number_vertices(SurfaceData& data, std::size_t count, std::size_t own) {
  data.original_ids.assign(count, -1);
  const auto end = data.original_ids.begin() + static_cast<std::ptrdiff_t>(own);
  std::iota(data.original_ids.begin(), end, std::int64_t{0});
}

// Completes a surface from its mesh.
SurfacePointer finished(SurfaceData&& data, Mesh&& mesh, Creases&& creases,
                        const Progress& progress) {
  Stopwatch watch;
  data.surface = make_surface(std::move(mesh), std::move(creases), progress);
  data.topology_milliseconds = watch.lap();
  return std::make_shared<SurfaceData>(std::move(data));
}

// The same for a mesh that is first split at creases, with its arrays.
SurfacePointer finished(SurfaceData&& data, Mesh&& mesh, float crease_angle,
                        const Progress& progress) {
  if (data.original_ids.empty()) number_vertices(data, mesh.vertex_count(), mesh.vertex_count());
  Creases creases = split_at_creases(mesh, crease_angle, progress);
  add_rows_of_copies(creases, data.arrays);
  add_rows_of_copies(creases, data.original_ids);
  data.crease_angle = crease_angle;
  return finished(std::move(data), std::move(mesh), std::move(creases), progress);
}

void check_array_rows(const DataArrays& arrays, std::size_t vertices, std::size_t cells,
                      const char* of_cells = "triangles") {
  const auto check = [](const std::vector<DataArray>& list, std::size_t rows, const char* of) {
    for (const DataArray& array : list) {
      if (array.rows() == rows) continue;
      throw Error("array '" + array.name + "': it has " + std::to_string(array.rows()) +
                  " rows for " + std::to_string(rows) + " " + of);
    }
  };
  check(arrays.points, vertices, "vertices");
  check(arrays.cells, cells, of_cells);
}

Table columns_of_three(py::handle object, const char* what) {
  Table table = table_of(object, what);
  check_columns(table.view, 3, what);
  return table;
}

Mesh unchecked_points(const ArrayView& positions) {
  std::vector<Eigen::Vector3d> places(positions.rows());
  for_each_number(positions, [&](std::size_t vertex, std::size_t axis, auto number) {
    places[vertex][static_cast<Eigen::Index>(axis)] = static_cast<double>(number);
  });
  Mesh mesh;
  mesh.origin = origin_near(places);
  mesh.positions = positions_about(mesh.origin, places);
  return mesh;
}

Mesh take_repaired(RepairedMesh&& repaired, SurfaceData& data) {
  data.repair = repaired.repair;
  data.vertices_joined = repaired.repair.vertices_joined;
  data.partners = data.vertex_of_row = std::move(repaired.vertex_of_row);
  if (!repaired.kept_triangles.empty() || repaired.mesh.triangles.empty()) {
    data.arrays.cells = rows_of(data.arrays.cells, repaired.kept_triangles);
  }
  return std::move(repaired.mesh);
}

void check_crease_angle(float degrees) {
  saying_in_pythons_words([&] { check_number("--crease-angle", degrees); });
}

SurfacePointer from_arrays(py::handle vertices, py::handle triangles, const py::dict& point_arrays,
                           const py::dict& cell_arrays, bool repair, float crease_angle) {
  check_crease_angle(crease_angle);
  const Table positions = columns_of_three(vertices, "vertices");
  refuse_masked(triangles, "faces");
  const Table corners = columns_of_three(triangles, "faces");
  SurfaceData data;
  data.name = "arrays";
  data.arrays = {data_arrays_of(point_arrays), data_arrays_of(cell_arrays)};
  Stopwatch watch;
  check_array_rows(data.arrays, positions.view.rows(), corners.view.rows());
  return until_interrupted([&](const Progress& progress) {
    Mesh mesh = repair ? take_repaired(make_repaired_mesh(positions.view, corners.view), data)
                       : make_mesh(positions.view, corners.view);
    data.load_milliseconds = watch.lap();
    return finished(std::move(data), std::move(mesh), crease_angle, progress);
  });
}

SurfacePointer from_points(LoadedPoints&& loaded, int neighbors, SurfaceData&& data,
                           const Progress& progress) {
  data.point_repair = loaded.repair;
  data.vertices_joined = loaded.repair.repeated;
  data.partners = data.vertex_of_row = std::move(loaded.first_at_place);
  data.left_out = std::move(loaded.left_out);
  if (!loaded.arrays.empty()) data.arrays.points = std::move(loaded.arrays);
  Stopwatch watch;
  data.surface = make_point_surface(std::move(loaded.cloud), neighbors, progress);
  data.topology_milliseconds = watch.lap();
  const std::size_t count = data.surface.mesh.vertex_count();
  number_vertices(data, count, count);
  return std::make_shared<SurfaceData>(std::move(data));
}

void check_neighbors(int neighbors) {
  saying_in_pythons_words([&] { check_number("--neighbors", neighbors); });
}

SurfacePointer from_point_arrays(py::handle points, py::handle normals, int neighbors,
                                 const py::dict& point_arrays) {
  check_neighbors(neighbors);
  const Table positions = columns_of_three(points, "points");
  std::vector<Vec3> directions;
  if (!normals.is_none()) {
    const Table table = columns_of_three(normals, "normals");
    check_rows(table.array, positions.view.rows(), "normals", "points");
    directions = vectors_of(table.view, "normals");
  }
  SurfaceData data;
  data.name = "arrays";
  data.arrays.points = data_arrays_of(point_arrays);
  const Mesh placed = unchecked_points(positions.view);
  check_array_rows(data.arrays, placed.vertex_count(), 0);
  return until_interrupted([&](const Progress& progress) {
    LoadedPoints loaded =
        make_point_cloud(placed.positions, std::move(directions), progress.part(0, kReading));
    loaded.cloud.origin = placed.origin;
    return from_points(std::move(loaded), neighbors, std::move(data), progress.part(kReading, 1));
  });
}

/// Number and kind of subdivisions.
struct Splitting {
  int times;
  Midpoints midpoints;
};

Splitting splitting(int times, bool rounded) {
  return {times, rounded ? Midpoints::rounded : Midpoints::straight};
}

SurfacePointer from_loaded(LoadedMesh&& loaded, SurfaceData&& data, const Splitting& split,
                           float crease_angle, const Progress& progress) {
  Stopwatch watch;
  const std::size_t own = loaded.mesh.vertex_count();
  if (split.times > 0) {
    subdivide(loaded.mesh, loaded.arrays, split.times, split.midpoints,
              progress.part(kReading, kSplit));
  }
  data.repair = loaded.repair;
  data.vertices_joined = loaded.repair.vertices_joined;
  data.arrays = std::move(loaded.arrays);
  data.left_out = std::move(loaded.left_out);
  if (!loaded.renumbered) data.partners = loaded.vertex_of_row;
  data.load_milliseconds += watch.lap();
  number_vertices(data, loaded.mesh.vertex_count(), loaded.renumbered ? 0 : own);
  if (loaded.renumbered) {
    for (std::size_t row = loaded.vertex_of_row.size(); row-- > 0;) {
      data.original_ids[loaded.vertex_of_row[row]] = static_cast<std::int64_t>(row);
    }
  }
  if (split.times == 0) data.vertex_of_row = std::move(loaded.vertex_of_row);
  return finished(std::move(data), std::move(loaded.mesh), crease_angle, progress.part(kSplit, 1));
}

SurfacePointer from_file(const std::filesystem::path& path, std::optional<bool> points,
                         int neighbors, const Splitting& split, float crease_angle,
                         const py::object& callback) {
  SurfaceData data;
  data.name = path.string();
  check_neighbors(neighbors);
  check_crease_angle(crease_angle);
  return Job(callback).run([&](const Progress& progress) {
    SurfaceFile file(path);
    const auto is_cloud = [&] { return file.is_point_cloud(progress); };
    if (!(points ? *points : saying_in_pythons_words(is_cloud))) {
      Stopwatch watch;
      LoadedMesh loaded = file.mesh(progress.part(0, kReading));
      data.load_milliseconds = watch.lap();
      return from_loaded(std::move(loaded), std::move(data), split, crease_angle, progress);
    }
    if (split.times > 0)
      throw Error(shown(path.native()) + ": points have no triangles to subdivide");
    Stopwatch watch;
    LoadedPoints loaded = file.points(progress);
    data.load_milliseconds = watch.lap();
    return from_points(std::move(loaded), neighbors, std::move(data), progress.part(kReading, 1));
  });
}

SurfacePointer from_shape(const std::string& spec, int times, bool rounded, float crease_angle) {
  check_crease_angle(crease_angle);
  SurfaceData data;
  data.name = std::string(kShapePrefix) + spec;
  return until_interrupted([&](const Progress& progress) {
    Stopwatch watch;
    Mesh mesh = make_shape(spec);
    const std::size_t own = mesh.vertex_count();
    if (times > 0) {
      mesh = subdivide(std::move(mesh), times, splitting(times, rounded).midpoints,
                       progress.part(0, kSplit));
    }
    data.load_milliseconds = watch.lap();
    number_vertices(data, mesh.vertex_count(), own);
    return finished(std::move(data), std::move(mesh), crease_angle, progress.part(kSplit, 1));
  });
}

using CellTypes = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

// The surface of cells, as of a VTK file with these, and of every triangle the row of its cell.
py::tuple from_cells(py::handle points, py::handle corners, py::handle ends,
                     const CellTypes& cell_types, const py::dict& point_arrays,
                     const py::dict& cell_arrays) {
  const std::vector<std::uint8_t> types(cell_types.data(), cell_types.data() + cell_types.size());
  CellArrays cells{data_array_of("points", points),
                   data_array_of("corners", corners),
                   data_array_of("ends", ends),
                   types,
                   {data_arrays_of(point_arrays), data_arrays_of(cell_arrays)}};
  check_array_rows(cells.arrays, cells.points.rows(), types.size(), "cells");
  std::vector<std::int64_t> rows(types.size());
  std::iota(rows.begin(), rows.end(), std::int64_t{0});
  cells.arrays.cells.push_back(make_data_array("row", 1, rows));  // behind those of the cells
  SurfaceData data;
  data.name = "arrays";
  DataArray cell_of_triangle;
  SurfacePointer made = until_interrupted([&](const Progress& progress) {
    LoadedMesh loaded = mesh_of_cells(std::move(cells), "the mesh");
    cell_of_triangle = std::move(loaded.arrays.cells.back());
    loaded.arrays.cells.pop_back();
    return from_loaded(std::move(loaded), std::move(data), {0, Midpoints::straight}, kNoCreases,
                       progress);
  });
  return py::make_tuple(made, array_owning(std::move(cell_of_triangle)));
}

// What stays with a surface whose mesh changes.
SurfaceData data_along_with(const SurfaceData& from) {
  SurfaceData data;
  data.name = from.name;
  data.arrays = from.arrays;
  data.vertices_joined = from.vertices_joined;
  data.partners = from.partners;
  data.original_ids = from.original_ids;
  data.crease_angle = from.crease_angle;
  return data;
}

// Removes rows of copies.
void drop_copies(std::size_t own, SurfaceData& data) {
  std::vector<Index> rows(own);
  std::iota(rows.begin(), rows.end(), Index{0});
  data.arrays.points = rows_of(data.arrays.points, rows);
  data.original_ids.resize(own);
}

SurfacePointer subdivided_surface(const SurfaceData& from, int times, bool rounded) {
  if (from.is_points()) throw Error("points have no triangles to subdivide");
  SurfaceData data = data_along_with(from);
  return until_interrupted([&](const Progress& progress) {
    Stopwatch watch;
    // Edges are split as before creases, then creases are found again.
    const std::size_t own = from.surface.own_vertex_count();
    Mesh mesh = joined_mesh(from.surface.mesh, from.surface.creases);
    mesh.positions.resize(own);
    if (!from.surface.creases.empty()) drop_copies(own, data);
    subdivide(mesh, data.arrays, times, splitting(times, rounded).midpoints,
              progress.part(0, kSplit));
    data.load_milliseconds = watch.lap();
    data.original_ids.resize(mesh.vertex_count(), -1);
    const float crease_angle = data.crease_angle;
    return finished(std::move(data), std::move(mesh), crease_angle, progress.part(kSplit, 1));
  });
}

// The same triangles with moved vertices.
SurfacePointer with_vertices(const SurfaceData& from, py::handle positions) {
  const Table table = columns_of_three(positions, "vertices");
  const Mesh& mesh = from.surface.mesh;
  const bool own = table.view.rows() == from.surface.own_vertex_count();
  if (!own) check_rows(table.array, mesh.vertex_count(), "vertices", "vertices");
  SurfaceData data = data_along_with(from);
  return until_interrupted([&](const Progress& progress) {
    Mesh moved_mesh = make_mesh(table.view, {});
    if (own) add_rows_of_copies(from.surface.creases, moved_mesh.positions);
    moved_mesh.triangles = mesh.triangles;
    return finished(std::move(data), std::move(moved_mesh), Creases(from.surface.creases),
                    progress);
  });
}

// Absolute positions: the mesh's floats, or doubles if its origin is not zero.
py::array placed_points(std::span<const Vec3> points, const Eigen::Vector3d& origin,
                        py::handle owner) {
  if (origin.isZero(0)) return shared_rows(points, owner);
  std::vector<double> numbers;
  numbers.reserve(3 * points.size());
  for (const Vec3& point : points) {
    const Eigen::Vector3d place = placed(point, origin);
    numbers.insert(numbers.end(), place.data(), place.data() + 3);
  }
  return owned<double>(std::move(numbers), {static_cast<py::ssize_t>(points.size()), 3});
}

const SurfaceData& data_of(py::handle self) { return py::cast<const SurfaceData&>(self); }

py::dict arrays_of(const std::vector<DataArray>& arrays, py::handle owner) {
  py::dict result;
  for (const DataArray& array : arrays) result[py::str(array.name)] = shared(array, owner);
  return result;
}

py::dict dict_of(const MeshRepair& repair) {
  return py::dict("vertices_not_finite"_a = repair.vertices_not_finite,
                  "vertices_joined"_a = repair.vertices_joined,
                  "vertices_unreferenced"_a = repair.vertices_unreferenced,
                  "triangles_out_of_range"_a = repair.triangles_out_of_range,
                  "triangles_not_finite"_a = repair.triangles_not_finite,
                  "triangles_degenerate"_a = repair.triangles_degenerate,
                  "triangles_duplicate"_a = repair.triangles_duplicate);
}

py::dict dict_of(const PointRepair& repair) {
  return py::dict("not_finite"_a = repair.not_finite, "repeated"_a = repair.repeated,
                  "without_normal"_a = repair.without_normal);
}

std::string description_of_repair(const SurfaceData& data) {
  return data.point_repair ? describe(*data.point_repair) : describe(data.repair);
}

py::tuple curvature_of(const SurfaceData& data) {
  const Surface& surface = data.surface;
  const auto curvatures = until_interrupted([&](const Progress& progress) {
    return principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood,
                                progress);
  });
  std::vector<float> maximum, minimum;
  std::vector<Vec3> maximum_directions, minimum_directions;
  for (const PrincipalCurvature& curvature : curvatures) {
    maximum.push_back(curvature.maximum);
    minimum.push_back(curvature.minimum);
    maximum_directions.push_back(curvature.maximum_direction);
    minimum_directions.push_back(curvature.minimum_direction);
  }
  return py::make_tuple(owned(std::move(maximum)), owned(std::move(minimum)),
                        owned(std::move(maximum_directions)), owned(std::move(minimum_directions)));
}

py::tuple nearest_places(const SurfaceData& data, py::handle points, double max_distance) {
  const Table table = columns_of_three(points, "points");
  const std::vector<double> numbers = doubles_of(table.view);
  const std::size_t count = table.view.rows();
  const Mesh& mesh = data.surface.mesh;
  if (data.is_points()) throw Error("points have no triangles to be near to");
  std::vector<std::int32_t> triangles(count, -1);
  std::vector<double> weights(3 * count, 0),
      distances(count, std::numeric_limits<double>::infinity());
  until_interrupted([&](const Progress& progress) {
    progress.report(kSearching, 0);
    const NearestOnMesh places(mesh);
    const auto search = [&](std::size_t i) {
      const Eigen::Vector3d point(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
      const auto place = places.nearest(point - mesh.origin, max_distance);
      if (!place) return;
      triangles[i] = static_cast<std::int32_t>(place->triangle);
      std::copy(place->barycentric.begin(), place->barycentric.end(), &weights[3 * i]);
      distances[i] = place->distance;
    };
    for (std::size_t begin = 0; begin < count; begin += kPointsBetweenLooks) {
      progress.report(kSearching, static_cast<double>(begin) / static_cast<double>(count));
      const std::size_t points_here = std::min(kPointsBetweenLooks, count - begin);
      parallel_for(
          points_here,
          [&](std::size_t from, std::size_t to) {
            for (std::size_t i = begin + from; i < begin + to; ++i) search(i);
          },
          kPointsOfTask);
    }
  });
  return py::make_tuple(owned(std::move(triangles)),
                        owned<double>(std::move(weights), {static_cast<py::ssize_t>(count), 3}),
                        owned(std::move(distances)));
}

// An array of one surface at the vertices of another.
py::array interpolate_to(const SurfaceData& from, const std::string& name, py::handle array,
                         const SurfaceData& to, double max_distance, bool axes) {
  const DataArrays values = surface_array_of(from.surface.mesh, name, array);
  return array_owning(until_interrupted([&](const Progress& progress) {
    const NearbyRows rows = nearby_rows(from.surface.mesh, to.surface.mesh, max_distance, progress);
    return chosen(values.points.empty() ? carried_from_cells(values.cells.front(), rows)
                                        : carried_from_points(values.points.front(), rows),
                  axes);
  }));
}

py::array transferred_to_points(const SurfaceData& data, const std::string& name, py::handle cells,
                                bool axes) {
  const DataArray values = data_array_of(name, cells);
  return array_owning(
      without_lock([&] { return chosen(cells_to_points(data.surface.mesh, values), axes); }));
}

// The array NAME, points/NAME or cells/NAME as axes, one per vertex.
py::array axes_named(const SurfaceData& data, const std::string& name) {
  const brindle::ArrayChoice choice = brindle::choice_of(data.arrays, name, data.name);
  return array_owning(without_lock([&] {
    const DataArray& array = *choice.array;
    return chosen(choice.of_cells ? cells_to_points(data.surface.mesh, array) : array, true);
  }));
}

// The array NAME, points/NAME or cells/NAME: its own name, itself, and whether it is of triangles.
py::tuple array_named(py::handle self, const std::string& name) {
  const SurfaceData& data = data_of(self);
  const auto [array, of_cells] = brindle::choice_of(data.arrays, name, data.name);
  return py::make_tuple(array->name, shared(*array, self), of_cells);
}

py::tuple origin_of(const SurfaceData& data) {
  const Eigen::Vector3d& origin = data.surface.mesh.origin;
  return py::make_tuple(origin.x(), origin.y(), origin.z());
}

std::string lines_of_splits(const SurfaceData& data) {
  std::string lines;
  for (const std::string& line : surface_warnings(data.surface, "repair=True joins them")) {
    lines += line + "\n";
  }
  return lines;
}

std::string up_of(const SurfaceData& data) {
  return std::string(name_of(usual_up_axis(data.name).value_or(UpAxis::y)));
}

double diagonal_of(const SurfaceData& data) { return bounding_box(data.surface.mesh).diagonal(); }

using SurfaceClass = py::class_<SurfaceData, SurfacePointer>;

void bind_properties(SurfaceClass& type) {
  type.def_readonly("name", &SurfaceData::name)
      .def_readonly("left_out", &SurfaceData::left_out)
      .def_property_readonly("up", up_of)
      .def_property_readonly("is_points", &SurfaceData::is_points)
      .def_property_readonly(
          "vertex_count", [](const SurfaceData& data) { return data.surface.mesh.vertex_count(); })
      .def_property_readonly(
          "face_count", [](const SurfaceData& data) { return data.surface.mesh.triangle_count(); })
      .def_property_readonly("edge_count",
                             [](const SurfaceData& data) { return data.surface.own_edge_count(); })
      .def_property_readonly("diagonal", diagonal_of)
      .def_property_readonly("origin", origin_of)
      .def_property_readonly("repair",
                             [](const SurfaceData& data) {
                               return data.point_repair ? dict_of(*data.point_repair)
                                                        : dict_of(data.repair);
                             })
      .def_property_readonly("repair_text", description_of_repair)
      .def_property_readonly("split_warning", lines_of_splits);
}

void bind_arrays(SurfaceClass& type) {
  def_rows(
      type, "local_vertices",
      [](const auto& data) -> auto& { return data.surface.mesh.positions; });
  def_rows(
      type, "normals", [](const auto& data) -> auto& { return data.surface.normals; });
  def_rows(
      type, "faces", [](const auto& data) -> auto& { return data.surface.mesh.triangles; });
  def_rows(
      type, "neighbor_offsets",
      [](const auto& data) -> auto& { return data.surface.neighborhood->offsets; });
  def_rows(
      type, "neighbors",
      [](const auto& data) -> auto& { return data.surface.neighborhood->neighbors; });
  def_rows(
      type, "joined", [](const auto& data) -> auto& { return data.vertex_of_row; });
  def_rows(
      type, "crease_vertices",
      [](const auto& data) -> auto& { return data.surface.creases.copied; });
  type.def_property_readonly("vertices",
                             [](py::handle self) {
                               const Mesh& mesh = data_of(self).surface.mesh;
                               return placed_points(mesh.positions, mesh.origin, self);
                             })
      .def_property_readonly(
          "point_data",
          [](py::handle self) { return arrays_of(data_of(self).arrays.points, self); })
      .def_property_readonly(
          "cell_data", [](py::handle self) { return arrays_of(data_of(self).arrays.cells, self); });
}

}  // namespace

void bind_surfaces(py::module_& module) {
  SurfaceClass type(module, "Surface");
  bind_properties(type);
  bind_arrays(type);
  bind_pickle(type);
  type.def("subdivide", subdivided_surface, py::arg("times"), py::arg("rounded"))
      .def("with_vertices", with_vertices, py::arg("vertices"))
      .def("curvature", curvature_of)
      .def("nearest", nearest_places, py::arg("points"), py::arg("max_distance"))
      .def("interpolate_to", interpolate_to, py::arg("name"), py::arg("array"), py::arg("target"),
           py::arg("max_distance"), py::arg("axes"))
      .def("axes_named", axes_named, py::arg("name"))
      .def("array_named", array_named, py::arg("name"))
      .def("cells_to_points", transferred_to_points, py::arg("name"), py::arg("cells"),
           py::arg("axes"));
  module.def("surface_of_arrays", from_arrays, py::arg("vertices"), py::arg("faces"),
             py::arg("point_data"), py::arg("cell_data"), py::arg("repair"),
             py::arg("crease_angle"));
  module.def("surface_of_points", from_point_arrays, py::arg("points"),
             py::arg("normals").none(true), py::arg("neighbors"), py::arg("point_data"));
  module.def(
      "read",
      [](const std::string& path, std::optional<bool> points, int neighbors, int times,
         bool rounded, float crease_angle, const py::object& progress) {
        return from_file(path, points, neighbors, splitting(times, rounded), crease_angle,
                         progress);
      },
      py::arg("path"), py::arg("points"), py::arg("neighbors"), py::arg("subdivide"),
      py::arg("rounded"), py::arg("crease_angle"), py::arg("progress"));
  module.def("surface_of_cells", from_cells, py::arg("points"), py::arg("corners"), py::arg("ends"),
             py::arg("types"), py::arg("point_data"), py::arg("cell_data"));
  module.def("shape", from_shape, py::arg("spec"), py::arg("subdivide"), py::arg("rounded"),
             py::arg("crease_angle"));
  module.def("shape_names", shape_names);
  module.def("shape_help", shape_help);
}

}  // namespace brindle::python
