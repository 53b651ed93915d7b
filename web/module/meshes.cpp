// Meshes of files and shapes, and their data.
#include <numeric>
#include <string>

#include <emscripten/bind.h>

#include "brindle/array_field.h"
#include "brindle/base/memory_file.h"
#include "brindle/creases.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/measured_field.h"
#include "brindle/mesh_data.h"
#include "brindle/shapes.h"
#include "objects.h"

namespace brindle::web {
namespace {

std::string bytes_of(const val& bytes) {
  std::string content(bytes["length"].as<std::size_t>(), '\0');
  val(emscripten::typed_memory_view(content.size(),
                                    reinterpret_cast<std::uint8_t*>(content.data())))
      .call<void>("set", bytes);
  return content;
}

/// The name without its folders, which messages mention.
std::string plain_name(const std::string& name) {
  const std::string file = name.substr(name.find_last_of("/\\") + 1);
  if (file.empty() || file == "." || file == "..") {
    throw Error("'" + name + "' is no name of a file");
  }
  return file;
}

std::shared_ptr<SurfaceObject> surface_from_file(const val& bytes, const std::string& name,
                                                 float crease_angle) {
  const MemoryFile file(plain_name(name), bytes_of(bytes));
  LoadedMesh loaded = read_mesh(file.name());
  std::vector<std::string> notes;
  add_lines(notes, describe(loaded.repair));
  add_lines(notes, loaded.left_out);
  auto object = surface_object(std::move(loaded.mesh), crease_angle, std::move(notes));
  object->vertex_of_row = std::move(loaded.vertex_of_row);
  object->arrays = std::move(loaded.arrays);
  add_rows_of_copies(object->surface.creases, object->arrays);
  return object;
}

std::shared_ptr<SurfaceObject> surface_from_shape(const std::string& spec, float crease_angle) {
  return surface_object(make_shape(spec), crease_angle, {});
}

/// The array of that name, a row per vertex; cell arrays are averaged. Throws Error with all names
/// if there is none.
DataArray array_at_vertices(const SurfaceObject& object, const std::string& name) {
  if (const DataArray* array = find_array(object.arrays.points, name)) return *array;
  if (const DataArray* array = find_array(object.arrays.cells, name)) {
    return cells_to_points(object.surface.mesh, *array);
  }
  std::string names;
  for (const auto* arrays : {&object.arrays.points, &object.arrays.cells}) {
    for (const DataArray& array : *arrays) names += (names.empty() ? "" : ", ") + array.name;
  }
  throw Error("there is no array '" + name + "'; there " +
              (names.empty() ? "are none" : "are " + names));
}

val arrays_of(const SurfaceObject& object) {
  val list = val::array();
  const auto add = [&](const std::vector<DataArray>& arrays, const char* of) {
    for (const DataArray& array : arrays) {
      val entry = val::object();
      put(entry, "name", val(array.name));
      put(entry, "of", val(std::string(of)));
      put(entry, "components", array.components);
      list.call<void>("push", entry);
    }
  };
  add(object.arrays.points, "points");
  add(object.arrays.cells, "cells");
  return list;
}

val array_values(const SurfaceObject& object, const std::string& name) {
  DataArray array = array_at_vertices(object, name);
  array.components = 1;  // number by number, in the same order
  return array_of(numbers_of(array.view(), "array '" + name + "'"));
}

/// Adds an array that JavaScript has read, a row per vertex without copies at creases.
void add_array(SurfaceObject& object, const std::string& name, int components, const val& numbers) {
  DataArrays arrays{{make_data_array(name, components, floats_of(numbers))}, {}};
  DataArray& array = arrays.points.front();
  if (array.rows() != object.surface.own_vertex_count()) {
    throw Error("array '" + array.name + "' has not a row for each vertex");
  }
  add_rows_of_copies(object.surface.creases, arrays);
  object.arrays.points.push_back(std::move(array));
}

val array_field(const SurfaceObject& object, const std::string& name, bool oriented) {
  return array_of(direction_field_of(object.surface, array_at_vertices(object, name), oriented));
}

val smoothed_field(const SurfaceObject& object, const val& directions, const val& frequencies,
                   const val& given) {
  FieldSmoothingOptions options;
  options.symmetry = int_of(given, "symmetry");
  options.periods = float_of(given, "periods");
  options.fill = float_of(given, "fill");
  const val singularities = given["singularities"];
  if (!singularities.isNull() && !singularities.isUndefined()) {
    options.singularities = singularities.as<std::size_t>();
  }
  MeasuredField measured;
  measured.directions = vectors_of(directions);
  measured.confidence = floats_of(given["confidence"]);
  FieldSmoothing smoothing(object.surface, options);
  const SmoothedField field = smoothing.frame(measured, floats_of(frequencies));
  val result = val::object();
  put(result, "directions", array_of(field.directions));
  put(result, "coherence", array_of(field.coherence));
  put(result, "filled", array_of(field.filled));
  return result;
}

/// Every triangle in four, so many times more.
std::shared_ptr<SurfaceObject> subdivided(const SurfaceObject& from, int times) {
  // Edges are split as they were before creases, and creases are found again.
  Mesh mesh = joined_mesh(from.surface.mesh, from.surface.creases);
  std::vector<Index> own(from.surface.own_vertex_count());
  std::iota(own.begin(), own.end(), Index{0});
  mesh.positions.resize(own.size());
  DataArrays arrays{rows_of(from.arrays.points, own), from.arrays.cells};
  subdivide(mesh, arrays, times);
  auto object = surface_object(std::move(mesh), from.crease_angle, {});
  object->vertex_of_row = from.vertex_of_row;
  object->arrays = std::move(arrays);
  add_rows_of_copies(object->surface.creases, object->arrays);
  object->subdivided = from.subdivided + times;
  return object;
}

}  // namespace

void bind_meshes() {
  using namespace emscripten;
  function("surfaceFromFile", guarded<surface_from_file>);
  function("surfaceFromShape", guarded<surface_from_shape>);
  function("shapeNames", optional_override([] { return array_of(shape_names()); }));
  function("arrays", &arrays_of);
  function("array", guarded<array_values>);
  function("addArray", guarded<add_array>);
  function("arrayField", guarded<array_field>);
  function("smoothedField", guarded<smoothed_field>);
  function("subdivided", guarded<subdivided>);
}

}  // namespace brindle::web
