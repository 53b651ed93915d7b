#include "brindle/texture_animator.h"

#include <atomic>

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/saved.h"
#include "brindle/texture_coordinates.h"
#include "frame_waves.h"
#include "given_options.h"
#include "job.h"
#include "pattern_data.h"

namespace brindle::python {
namespace {

constexpr const char* kOrientations[] = {"afresh", "kept", "continued", "shortened"};

// One frame at a time; concurrent calls are rejected.
struct TextureAnimatorData {
  SurfacePointer surface;
  TextureAnimator animator;
  MovingNormals normals;
  py::dict metrics;
  std::atomic<bool> busy{false};

  TextureAnimatorData(SurfacePointer on, TextureAnimator with)
      : surface(std::move(on)), animator(std::move(with)), normals(surface->surface) {}
};

std::unique_ptr<TextureAnimatorData> make_texture_animator(const SurfacePointer& surface,
                                                           bool oriented, const py::dict& solver,
                                                           float stiffness, py::handle slack,
                                                           py::handle branch_penalty) {
  TextureAnimatorOptions options;
  const GivenOptions given(solver);
  given("--sweeps", options.stripes.sweeps);
  given("--cycles", options.stripes.cycles);
  options.oriented = oriented;
  options.stripes.lambda = stiffness;
  options.stripes.slack = slack_of(slack, branch_penalty, surface->surface.mesh);
  return std::make_unique<TextureAnimatorData>(surface, TextureAnimator(surface->surface, options));
}

py::tuple saved_texture_animator(TextureAnimatorData& data) {
  const OneAtATime alone(data.busy, "this animator");
  return py::make_tuple(py::bytes(saved_bytes(data.surface->surface, data.animator)), data.metrics);
}

std::unique_ptr<TextureAnimatorData> loaded_texture_animator(const SurfacePointer& surface,
                                                             const py::bytes& bytes,
                                                             py::dict metrics) {
  auto data = std::make_unique<TextureAnimatorData>(
      surface, texture_animator_of_bytes(static_cast<std::string_view>(bytes)).result);
  data->metrics = std::move(metrics);
  return data;
}

py::dict metrics_of(const TextureFrameResult& result) {
  const TexturePattern& pattern = result.pattern;
  return py::dict(
      "orientation"_a = kOrientations[static_cast<std::size_t>(result.orientation)],
      "phase_step_u"_a = result.u.phase_step, "phase_step_v"_a = result.v.phase_step,
      "branches_u"_a = pattern.u.quality.branches, "branches_v"_a = pattern.v.quality.branches,
      "turned_edges"_a = pattern.seams.turned, "mirrored_edges"_a = pattern.seams.mirrored,
      "unoriented_triangles"_a = pattern.seams.unoriented_triangles,
      "angle_distortion_mean_deg"_a = pattern.quality.angle_mean_deg,
      "area_distortion_mean"_a = pattern.quality.area_mean);
}

py::array texture_frame(TextureAnimatorData& data, py::handle directions, py::handle frequencies,
                        py::handle positions, py::handle frequencies_v, py::handle normals,
                        const py::object& progress) {
  const OneAtATime alone(data.busy, "this animator");
  const Mesh& mesh = data.surface->surface.mesh;
  const FrameIn u(data.surface->surface, std::ref(data.normals), MovedNormals::computed, directions,
                  frequencies, positions, normals);
  TextureFrameInput input{u.input()};
  input.normals = u.input().normals;
  std::optional<FrequenciesIn> v;
  if (!frequencies_v.is_none()) {
    v.emplace(frequencies_v, mesh, "frequencies_v", u.input().directions);
    input.frequencies_v = v->rows();
  }
  std::vector<float> uv;
  std::optional<TextureFrameResult> result;
  Job(progress).run([&](const Progress& reports) {
    result.emplace(data.animator.frame(input, reports));
    uv = corner_texture_coordinates(result->pattern.waves, result->pattern.phase_shift);
  });
  data.metrics = metrics_of(*result);
  return owned<float>(std::move(uv), {static_cast<py::ssize_t>(mesh.triangle_count()), 3, 2});
}

}  // namespace

void bind_texture_animator(py::module_& module) {
  py::class_<TextureAnimatorData>(module, "TextureAnimator")
      .def(py::init(&make_texture_animator), py::arg("surface").none(false), py::arg("oriented"),
           py::arg("solver"), py::arg("stiffness"), py::arg("slack"), py::arg("avoid_branches"))
      .def_readonly("metrics", &TextureAnimatorData::metrics)
      .def("saved", saved_texture_animator)
      .def_static("loaded", loaded_texture_animator)
      .def("frame", texture_frame, py::arg("directions"), py::arg("frequencies"),
           py::arg("positions"), py::arg("frequencies_v"), py::arg("normals"), py::arg("progress"))
      .def("restart", [](TextureAnimatorData& data) {
        const OneAtATime alone(data.busy, "this animator");
        data.animator.restart();
      });
}

}  // namespace brindle::python
