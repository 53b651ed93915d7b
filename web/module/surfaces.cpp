#include <algorithm>

#include <emscripten/bind.h>

#include "brindle/creases.h"
#include "brindle/error.h"
#include "brindle/mesh.h"
#include "objects.h"

namespace brindle::web {
namespace {

std::shared_ptr<SurfaceObject> surface_from_arrays(const val& positions, const val& triangles,
                                                   bool repair, float crease_angle) {
  const Table places(positions, 3), corners(triangles, 3);
  if (!repair) {
    return surface_object(make_mesh(places.view(), corners.view()), crease_angle, {});
  }
  RepairedMesh repaired = make_repaired_mesh(places.view(), corners.view());
  std::vector<std::string> notes;
  add_lines(notes, describe(repaired.repair));
  if (repaired.mesh.triangles.empty()) throw Error("no triangle is left after repairs");
  auto object = surface_object(std::move(repaired.mesh), crease_angle, std::move(notes));
  object->vertex_of_row = std::move(repaired.vertex_of_row);
  return object;
}

const Surface& of(const SurfaceObject& object) { return object.surface; }

val origin_of(const SurfaceObject& object) {
  val list = val::array();
  for (const double coordinate : of(object).mesh.origin) list.call<void>("push", coordinate);
  return list;
}

}  // namespace

void add_lines(std::vector<std::string>& notes, const std::string& lines) {
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    if (end > begin) notes.push_back(lines.substr(begin, end - begin));
    begin = end + 1;
  }
}

std::shared_ptr<SurfaceObject> surface_object(Mesh mesh, float crease_angle,
                                              std::vector<std::string> notes) {
  Creases creases = split_at_creases(mesh, crease_angle);
  auto object = std::make_shared<SurfaceObject>();
  object->crease_angle = crease_angle;
  object->surface = make_surface(std::move(mesh), std::move(creases));
  object->notes = std::move(notes);
  for (const std::string& warning : surface_warnings(object->surface, words_for(*object).join)) {
    object->notes.push_back(warning);
  }
  return object;
}

WarningWords words_for(const SurfaceObject& object) {
  WarningWords words;
  words.subdivided = object.subdivided;
  words.join = "join them";
  return words;
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
                  return array_of(of(s).mesh.positions);
                }))
      .function("normals",
                optional_override([](const SurfaceObject& s) { return array_of(of(s).normals); }))
      .function("vertexOfRow",
                optional_override([](const SurfaceObject& s) { return array_of(s.vertex_of_row); }))
      .function("creaseVertices", optional_override([](const SurfaceObject& s) {
                  return array_of(of(s).creases.copied);
                }))
      .function("notes",
                optional_override([](const SurfaceObject& s) { return array_of(s.notes); }))
      .function("triangles", optional_override([](const SurfaceObject& s) {
                  return array_of(of(s).mesh.triangles);
                }))
      .function("origin", &origin_of);
  function("surfaceFromArrays", guarded<surface_from_arrays>);
}

}  // namespace brindle::web
