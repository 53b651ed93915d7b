// Reliefs of textures, for builds with OpenGL, which have the tiles.
#include "brindle/relief.h"

#include <cstdint>
#include <optional>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/renderer.h"
#include "brindle/texture_coordinates.h"
#include "job.h"
#include "pattern_data.h"
#include "pictures.h"

namespace brindle::python {
namespace {

/// Arguments of `relief`; the kind, `only` and default of `fill_holes` follow from them.
struct ReliefRequest {
  ReliefOptions options;
  ReliefFaces faces;
  bool keep_flat = false;
  std::optional<float> fill_holes;
};

ReliefOptions options_of(const ReliefRequest& request, const TextureData& texture) {
  const Surface& surface = texture.surface->surface;
  ReliefOptions options = request.options;
  const bool is_raised = options.kind == ReliefKind::raised;
  const float standard = kFilledHoles * bounding_box(surface.mesh).diagonal();
  options.fill_holes = request.fill_holes.value_or(is_raised ? standard : 0);
  ReliefFaces faces = request.faces;
  if (request.keep_flat) {
    const auto& stripes = texture.is_cross() ? texture.cover : texture.u;
    faces.flat_width = static_cast<float>(mean_spacing(stripes->pattern.waves.frequencies));
  }
  options.only = chosen_faces(surface, faces);
  return options;
}

py::dict report_of(const Relief& relief) {
  py::dict report;
  visit_metrics(relief, [&](const char* name, const auto& value) { report[name] = value; });
  return report;
}

/// Positions, triangles, and the report.
py::tuple relief(const TextureData& texture, py::handle tile, std::optional<bool> whole,
                 const ReliefRequest& request, const py::object& progress) {
  const TextureTile chosen = tile_of(tile);
  Relief made = Job(progress).run([&](const Progress& reports) {
    const ReliefOptions options = options_of(request, texture);
    const auto broken = broken_tiles_of(texture, chosen, whole);
    const TexturedMesh coordinates = texture_coordinates(
        texture.surface->surface.mesh, texture.waves, texture.phase_shift, reports.part(0, 0.1));
    const auto height = [&](float u, float v) { return tile_height(chosen, u, v); };
    return make_relief(texture.surface->surface,
                       {coordinates, height, broken ? &*broken : nullptr, tile_detail(chosen)},
                       options, reports.part(0.1, 1));
  });
  const py::dict report = report_of(made);
  const auto count = static_cast<py::ssize_t>(made.mesh.triangle_count());
  return py::make_tuple(owned(std::move(made.mesh.positions)),
                        owned<std::int32_t>(std::move(made.mesh.triangles), {count, 3}), report);
}

}  // namespace

void bind_relief(py::module_& module) {
  py::class_<ReliefRequest>(module, "ReliefRequest")
      .def(py::init<>())
      .def_readwrite("keep_flat", &ReliefRequest::keep_flat)
      .def_readwrite("fill_holes", &ReliefRequest::fill_holes)
      .def_property(
          "height", [](const ReliefRequest& r) { return r.options.height; },
          [](ReliefRequest& r, float height) { r.options.height = height; })
      .def_property(
          "tolerance", [](const ReliefRequest& r) { return r.options.tolerance; },
          [](ReliefRequest& r, float tolerance) { r.options.tolerance = tolerance; })
      .def(
          "make_inlay",
          [](ReliefRequest& r, float depth) {
            r.options.kind = ReliefKind::inlay;
            r.options.depth = depth;
          },
          py::arg("depth"))
      .def("make_cut", [](ReliefRequest& r) { r.options.kind = ReliefKind::cut; })
      .def(
          "choose_towards",
          [](ReliefRequest& r, float x, float y, float z, float degrees) {
            r.faces.towards = Vec3(x, y, z);
            r.faces.degrees = degrees;
          },
          py::arg("x"), py::arg("y"), py::arg("z"), py::arg("degrees"))
      .def(
          "choose_weights",
          [](ReliefRequest& r,
             const py::array_t<float, py::array::c_style | py::array::forcecast>& weights) {
            r.faces.weights.assign(weights.data(), weights.data() + weights.size());
          },
          py::arg("weights"));
  module.def("relief", relief, py::arg("texture"), py::arg("tile"), py::arg("whole").none(true),
             py::arg("request"), py::arg("progress"));
}

}  // namespace brindle::python
