#include <filesystem>
#include <fstream>
#include <sstream>

#include <emscripten/bind.h>

#include "brindle/camera.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/mesh.h"
#include "brindle/mesh_data.h"
#include "brindle/shapes.h"
#include "objects.h"

namespace brindle::web {
namespace {

void add_lines(std::vector<std::string>& notes, const std::string& lines) {
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);) {
    if (!line.empty()) notes.push_back(line);
  }
}

std::shared_ptr<SurfaceObject> surface_of(Mesh mesh, std::vector<std::string> notes) {
  auto object = std::make_shared<SurfaceObject>();
  object->surface = make_surface(std::move(mesh));
  object->notes = std::move(notes);
  for (const std::string& warning : surface_warnings(object->surface, "join them")) {
    object->notes.push_back(warning);
  }
  return object;
}

std::shared_ptr<SurfaceObject> surface_from_arrays(val positions, val triangles, bool repair) {
  return guarded([&] {
    const Table places(positions, 3), corners(triangles, 3);
    if (!repair) return surface_of(make_mesh(places.view(), corners.view()), {});
    RepairedMesh repaired = make_repaired_mesh(places.view(), corners.view());
    std::vector<std::string> notes;
    add_lines(notes, describe(repaired.repair));
    if (repaired.mesh.triangles.empty()) throw Error("no triangle is left after repairs");
    auto object = surface_of(std::move(repaired.mesh), std::move(notes));
    object->vertex_of_row = std::move(repaired.vertex_of_row);
    return object;
  });
}

std::shared_ptr<SurfaceObject> surface_from_shape(std::string spec) {
  return guarded([&] { return surface_of(make_shape(spec), {}); });
}

/// A file that is there as long as this lives, under its own name, which messages name.
class TemporaryFile {
 public:
  TemporaryFile(const val& bytes, const std::string& name) : path_(plain(name)) {
    std::vector<char> content(bytes["length"].as<std::size_t>());
    val(emscripten::typed_memory_view(content.size(),
                                      reinterpret_cast<std::uint8_t*>(content.data())))
        .call<void>("set", bytes);
    std::ofstream out(path_, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    if (!out) throw Error(path_.string() + ": memory does not suffice for it");
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  static std::filesystem::path plain(const std::string& name) {
    const std::size_t slash = name.find_last_of("/\\");
    const std::string file = slash == std::string::npos ? name : name.substr(slash + 1);
    if (file.empty() || file == "." || file == "..") {
      throw Error("'" + name + "' is no name of a file");
    }
    return file;
  }

  std::filesystem::path path_;
};

std::shared_ptr<SurfaceObject> surface_from_file(val bytes, std::string name) {
  return guarded([&] {
    const TemporaryFile file(bytes, name);
    LoadedMesh loaded = read_mesh(file.path());
    std::vector<std::string> notes;
    add_lines(notes, describe(loaded.repair));
    add_lines(notes, loaded.left_out);
    auto object = surface_of(std::move(loaded.mesh), std::move(notes));
    object->vertex_of_row = std::move(loaded.vertex_of_row);
    object->arrays = std::move(loaded.arrays);
    return object;
  });
}

const Surface& of(const SurfaceObject& object) { return object.surface; }

val triangles_of(const SurfaceObject& object) {
  const std::vector<Triangle>& triangles = of(object).mesh.triangles;
  return array_of(std::span<const std::uint32_t>(triangles.data()->data(), 3 * triangles.size()));
}

val arrays_of(const SurfaceObject& object) {
  val list = val::array();
  const auto add = [&](const std::vector<DataArray>& arrays, const char* of) {
    for (const DataArray& array : arrays) {
      val entry = val::object();
      entry.set("name", array.name);
      entry.set("of", std::string(of));
      entry.set("components", array.components);
      list.call<void>("push", entry);
    }
  };
  add(object.arrays.points, "points");
  add(object.arrays.cells, "cells");
  return list;
}

val array_values(const SurfaceObject& object, std::string name) {
  return guarded([&] {
    DataArray array = array_at_vertices(object, name);
    array.components = 1;  // number by number, as they lie there
    const std::vector<float> numbers = numbers_of(array.view(), "array '" + name + "'");
    return array_of(std::span<const float>(numbers));
  });
}

/// Where the tool's --camera looks from.
val camera_of(const SurfaceObject& object, val given) {
  return guarded([&] {
    CameraView view;
    view.azimuth_deg = given["azimuth"].as<float>();
    view.elevation_deg = given["elevation"].as<float>();
    view.zoom = given["zoom"].as<float>();
    view.up = given["up"].as<std::string>() == "z" ? UpAxis::z : UpAxis::y;
    const Camera camera = framed_camera(points_of_triangles(of(object).mesh), view,
                                        given["width"].as<int>(), given["height"].as<int>());
    const auto numbers = [](const Eigen::Matrix4f& matrix) {
      return array_of(std::span<const float>(matrix.data(), 16));
    };
    const Vec3 up = camera.view_from_world.col(view.up == UpAxis::z ? 2 : 1).head<3>();
    val result = val::object();
    result.set("viewFromWorld", numbers(camera.view_from_world));
    result.set("clipFromView", numbers(camera.clip_from_view));
    result.set("up", array_of(std::span<const float>(up.data(), 3)));
    return result;
  });
}

val origin_of(const SurfaceObject& object) {
  val list = val::array();
  for (const double coordinate : of(object).mesh.origin) list.call<void>("push", coordinate);
  return list;
}

}  // namespace

DataArray array_at_vertices(const SurfaceObject& object, const std::string& name) {
  if (const DataArray* array = find_array(object.arrays.points, name)) return *array;
  if (const DataArray* array = find_array(object.arrays.cells, name)) {
    return cells_to_points(of(object).mesh, *array);
  }
  std::string names;
  for (const auto* arrays : {&object.arrays.points, &object.arrays.cells}) {
    for (const DataArray& array : *arrays) names += (names.empty() ? "" : ", ") + array.name;
  }
  throw Error("there is no array '" + name + "'; there " +
              (names.empty() ? "are none" : "are " + names));
}

void bind_surfaces() {
  using namespace emscripten;
  class_<SurfaceObject>("SurfaceObject")
      .smart_ptr<std::shared_ptr<SurfaceObject>>("SurfacePointer")
      .function("vertexCount",
                optional_override([](const SurfaceObject& s) { return of(s).mesh.vertex_count(); }))
      .function("triangleCount", optional_override([](const SurfaceObject& s) {
                  return of(s).mesh.triangle_count();
                }))
      .function("diagonal", optional_override([](const SurfaceObject& s) {
                  return bounding_box(of(s).mesh).diagonal();
                }))
      .function("positions", optional_override([](const SurfaceObject& s) {
                  return array_of(std::span<const Vec3>(of(s).mesh.positions));
                }))
      .function("normals", optional_override([](const SurfaceObject& s) {
                  return array_of(std::span<const Vec3>(of(s).normals));
                }))
      .function("vertexOfRow", optional_override([](const SurfaceObject& s) {
                  return array_of(std::span<const std::uint32_t>(s.vertex_of_row));
                }))
      .function("notes",
                optional_override([](const SurfaceObject& s) { return array_of(s.notes); }))
      .function("triangles", &triangles_of)
      .function("camera", &camera_of)
      .function("arrays", &arrays_of)
      .function("array", &array_values)
      .function("origin", &origin_of);
  function("surfaceFromArrays", &surface_from_arrays);
  function("surfaceFromShape", &surface_from_shape);
  function("surfaceFromFile", &surface_from_file);
  function("shapeNames", optional_override([] { return array_of(shape_names()); }));
}

}  // namespace brindle::web
