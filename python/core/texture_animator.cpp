#include "brindle/texture_animator.h"

#include <atomic>

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/texture_coordinates.h"
#include "frame_waves.h"
#include "job.h"
#include "pattern_data.h"

namespace brindle::python {
namespace {

constexpr const char* kOrientations[] = {"afresh", "kept", "continued", "shortened"};

// One frame at a time; concurrent calls are rejected.
struct TextureAnimatorData {
  SurfacePointer surface;
  PhaseShiftKind phase_shift;
  TextureAnimator animator;
  MovingNormals normals;
  py::dict metrics;
  std::atomic<bool> busy{false};

  TextureAnimatorData(SurfacePointer on, const TextureAnimatorOptions& options)
      : surface(std::move(on)),
        phase_shift(options.stripes.phase_shift),
        animator(surface->surface, options),
        normals(surface->surface) {}
};

std::unique_ptr<TextureAnimatorData> make_texture_animator(const SurfacePointer& surface,
                                                           bool oriented, float lambda, int sweeps,
                                                           int cycles, py::handle slack,
                                                           py::handle branch_penalty) {
  check_numbers(lambda, sweeps, cycles);
  TextureAnimatorOptions options;
  options.oriented = oriented;
  options.stripes.lambda = lambda;
  options.stripes.sweeps = sweeps;
  options.stripes.cycles = cycles;
  options.stripes.slack = slack_of(slack, branch_penalty, surface->surface.mesh);
  return std::make_unique<TextureAnimatorData>(surface, options);
}

py::dict metrics_of(const TextureFrameResult& result) {
  py::dict metrics;
  metrics["orientation"] = kOrientations[static_cast<std::size_t>(result.orientation)];
  metrics["phase_step_u"] = result.u.phase_step;
  metrics["phase_step_v"] = result.v.phase_step;
  metrics["branches_u"] = result.pattern.u.quality.branches;
  metrics["branches_v"] = result.pattern.v.quality.branches;
  metrics["turned_edges"] = result.pattern.seams.turned;
  metrics["mirrored_edges"] = result.pattern.seams.mirrored;
  metrics["unoriented_triangles"] = result.pattern.seams.unoriented_triangles;
  metrics["angle_distortion_mean_deg"] = result.pattern.quality.angle_mean_deg;
  metrics["area_distortion_mean"] = result.pattern.quality.area_mean;
  return metrics;
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
    uv = corner_texture_coordinates(result->pattern.waves, data.phase_shift);
  });
  data.metrics = metrics_of(*result);
  return owned<float>(std::move(uv), {static_cast<py::ssize_t>(mesh.triangle_count()), 3, 2});
}

}  // namespace

void bind_texture_animator(py::module_& module) {
  py::class_<TextureAnimatorData>(module, "TextureAnimator")
      .def(py::init(&make_texture_animator), py::arg("surface").none(false), py::arg("oriented"),
           py::arg("lambda_"), py::arg("sweeps"), py::arg("cycles"), py::arg("slack"),
           py::arg("avoid_branches"))
      .def_property_readonly("surface",
                             [](const TextureAnimatorData& data) { return data.surface; })
      .def_property_readonly("metrics",
                             [](const TextureAnimatorData& data) { return data.metrics; })
      .def("frame", texture_frame, py::arg("directions"), py::arg("frequencies"),
           py::arg("positions"), py::arg("frequencies_v"), py::arg("normals"), py::arg("progress"))
      .def("restart", [](TextureAnimatorData& data) {
        const OneAtATime alone(data.busy, "this animator");
        data.animator.restart();
      });
}

}  // namespace brindle::python
