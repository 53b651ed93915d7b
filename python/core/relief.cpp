// Reliefs of textures, for builds with OpenGL, which have the tiles.
#include "brindle/relief.h"

#include <array>
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
#include "words.h"

namespace brindle::python {
namespace {

/// Arguments of `relief`; the kind, `only` and default of `fill_holes` follow from them.
struct ReliefRequest {
  ReliefOptions options;
  ReliefFaces faces;
  bool keep_flat = false;
  std::optional<float> fill_holes;
};

ReliefRequest relief_request(const py::dict& options) {
  using Numbers = py::array_t<float, py::array::c_style | py::array::forcecast>;
  const GivenOptions given(options);
  ReliefRequest request;
  ReliefOptions& relief = request.options;
  bool cut = false;
  std::optional<float> inlay;
  std::optional<std::array<float, 4>> towards;  // and the angle from there
  std::optional<Numbers> weights;
  given("--height", relief.height);
  given("--tolerance", relief.tolerance);
  given("--keep-flat", request.keep_flat);
  given("--fill-holes", request.fill_holes);
  given("--cut", cut);
  given("--inlay", inlay);
  given("--towards", towards);
  given("--weights", weights);
  if (cut) relief.kind = ReliefKind::cut;
  if (inlay) {
    relief.kind = ReliefKind::inlay;
    relief.depth = *inlay;
  }
  if (towards) {
    request.faces.towards = Vec3(towards->data());
    request.faces.degrees = towards->back();
  }
  if (weights) request.faces.weights.assign(weights->data(), weights->data() + weights->size());
  return request;
}

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
                 const py::dict& given, const py::object& progress) {
  const ReliefRequest request = relief_request(given);
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
  module.def("relief", relief, py::arg("texture"), py::arg("tile"), py::arg("whole").none(true),
             py::arg("request"), py::arg("progress"));
}

}  // namespace brindle::python
