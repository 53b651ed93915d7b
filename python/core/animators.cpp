#include <algorithm>
#include <atomic>

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/recipe/refusals.h"
#include "brindle/saved.h"
#include "brindle/stripe_animator.h"
#include "brindle/texture_animator.h"
#include "brindle/texture_coordinates.h"
#include "brindle/waves/parsed_words.h"
#include "frame_waves.h"
#include "job.h"
#include "pattern_data.h"
#include "words.h"

namespace brindle::python {
namespace {

// One frame at a time; concurrent calls are rejected.
template <class Animator>
struct Animated {
  SurfacePointer surface;
  Animator animator;
  MovingNormals normals;
  std::atomic<bool> busy{false};

  Animated(SurfacePointer on, Animator with)
      : surface(std::move(on)), animator(std::move(with)), normals(surface->surface) {}
};

template <class Data>
void restart(Data& data) {
  const OneAtATime alone(data.busy, "this animator");
  data.animator.restart();
}

struct AnimatorData : Animated<StripeAnimator> {
  using Animated::Animated;
  std::vector<float> frequencies;  // of the last frame, with slack
  double phase_step = 0;
  bool unchanged = false;
  FrameMilliseconds milliseconds;
  double topology_milliseconds = 0;
};

FrameSolver frame_solver(const std::string& name) {
  if (name == "multilevel") return FrameSolver::multilevel;
  if (name == "relaxation") return FrameSolver::relaxation;
  throw Error("solver: '" + name + "' is neither multilevel nor relaxation");
}

std::unique_ptr<AnimatorData> make_animator(const SurfacePointer& surface, const py::dict& solver,
                                            float stiffness, const py::object& edge_weights,
                                            py::handle slack, py::handle branch_penalty) {
  AnimatorOptions options;
  const GivenOptions given(solver);
  given("--solver", options.solver,
        [](const std::string& name) { return std::optional(frame_solver(name)); });
  given("--sweeps", options.sweeps);
  given("--cycles", options.cycles);
  given("--iterations", options.iterations);
  given("--phase-shift", options.phase_shift, parse_phase_shift_kind);
  options.lambda = stiffness;
  saying_in_pythons_words([&] {
    if (options.solver == FrameSolver::multilevel) {
      refuse_given(given.is_given(), {"--iterations"}, "it is for --solver relaxation");
    } else {
      refuse_given(given.is_given(), {"--sweeps", "--cycles"}, "it is for --solver multilevel");
    }
  });
  if (!edge_weights.is_none()) {
    const Table table = table_of(edge_weights, "edge_weights");
    check_rows(table.array, surface->surface.neighborhood->directed_edge_count(), "edge_weights",
               "directed edges");
    options.edge_weights = numbers_of(table.view, "edge_weights");
  }
  options.slack = slack_of(slack, branch_penalty, surface->surface.mesh);
  return std::make_unique<AnimatorData>(surface, StripeAnimator(surface->surface, options));
}

// The array for the phases: `out`, if there is one, or a new one.
py::array_t<Complex> phase_array(py::handle out, std::size_t count) {
  if (out.is_none()) return py::array_t<Complex>(static_cast<py::ssize_t>(count));
  if (!py::isinstance<py::array_t<Complex, py::array::c_style>>(out)) {
    throw py::type_error("out: expected a packed array of complex64");
  }
  auto array = py::reinterpret_borrow<py::array_t<Complex>>(out);
  if (array.ndim() != 1 || array.size() != static_cast<py::ssize_t>(count) || !array.writeable()) {
    throw Error("out: expected an array of " + std::to_string(count) + " that can be written to");
  }
  return array;
}

py::array_t<Complex> frame(AnimatorData& data, py::handle directions, py::handle frequencies,
                           py::handle positions, py::handle out, const py::object& progress) {
  const OneAtATime alone(data.busy, "this animator");
  const std::size_t vertices = data.surface->surface.mesh.vertex_count();
  const FrameIn in(data.surface->surface, std::ref(data.normals), MovedNormals::left_out,
                   directions, frequencies, positions);
  py::array_t<Complex> phases = phase_array(out, vertices);
  Complex* target = phases.mutable_data();
  FrameResult result;
  Job(progress).run([&](const Progress& reports) {
    result = data.animator.frame(in.input(), reports);
    std::copy(result.z.begin(), result.z.end(), target);
  });
  // Under the GIL, which readers hold.
  data.phase_step = result.phase_step;
  data.unchanged = result.unchanged;
  data.milliseconds = result.milliseconds;
  data.topology_milliseconds = data.animator.topology_milliseconds();
  data.frequencies.assign(result.frequencies.begin(), result.frequencies.end());
  return phases;
}

std::unique_ptr<AnimatorData> sibling_of(AnimatorData& data) {
  const OneAtATime alone(data.busy, "this animator");
  return std::make_unique<AnimatorData>(data.surface, data.animator.sibling());
}

py::tuple saved_animator(AnimatorData& data) {
  const OneAtATime alone(data.busy, "this animator");
  return py::make_tuple(py::bytes(saved_bytes(data.surface->surface, data.animator)),
                        data.phase_step, data.unchanged, data.frequencies);
}

std::unique_ptr<AnimatorData> loaded_animator(const SurfacePointer& surface, const py::bytes& bytes,
                                              double phase_step, bool unchanged,
                                              std::vector<float> frequencies) {
  auto data = std::make_unique<AnimatorData>(
      surface, stripe_animator_of_bytes(static_cast<std::string_view>(bytes)).result);
  data->phase_step = phase_step;
  data->unchanged = unchanged;
  data->frequencies = std::move(frequencies);
  return data;
}

constexpr const char* kOrientations[] = {"afresh", "kept", "continued", "shortened"};

struct TextureAnimatorData : Animated<TextureAnimator> {
  using Animated::Animated;
  py::dict metrics;
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

py::dict texture_metrics(const TextureFrameResult& result) {
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
  data.metrics = texture_metrics(*result);
  return owned<float>(std::move(uv), {static_cast<py::ssize_t>(mesh.triangle_count()), 3, 2});
}

}  // namespace

void bind_animators(py::module_& module) {
  py::class_<AnimatorData>(module, "Animator")
      .def(py::init(&make_animator), py::arg("surface").none(false), py::arg("solver"),
           py::arg("stiffness"), py::arg("edge_weights"), py::arg("slack"),
           py::arg("avoid_branches"))
      .def("frame", frame, py::arg("directions"), py::arg("frequencies"), py::arg("positions"),
           py::arg("out"), py::arg("progress"))
      .def_readonly("phase_step", &AnimatorData::phase_step)
      .def_readonly("unchanged", &AnimatorData::unchanged)
      .def_property_readonly("milliseconds",
                             [](const AnimatorData& data) {
                               const FrameMilliseconds& times = data.milliseconds;
                               return py::dict("frequency"_a = times.frequency,
                                               "couple"_a = times.couple, "sum"_a = times.sum,
                                               "solve"_a = times.solve);
                             })
      .def_readonly("topology_milliseconds", &AnimatorData::topology_milliseconds)
      .def("frequencies",
           [](const AnimatorData& data) { return owned(std::vector<float>(data.frequencies)); })
      .def("energy",
           [](AnimatorData& data) {
             const OneAtATime alone(data.busy, "this animator");
             return without_lock([&] { return data.animator.energy(); });
           })
      .def("sibling", sibling_of)
      .def("saved", saved_animator)
      .def_static("loaded", loaded_animator)
      .def("restart", restart<AnimatorData>)
      .def(
          "set_phases",
          [](AnimatorData& data, py::handle phases) {
            const OneAtATime alone(data.busy, "this animator");
            data.animator.set_last_phases(phases_of(phases, data.surface->surface.mesh, "phases"));
          },
          py::arg("phases"));
  py::class_<TextureAnimatorData>(module, "TextureAnimator")
      .def(py::init(&make_texture_animator), py::arg("surface").none(false), py::arg("oriented"),
           py::arg("solver"), py::arg("stiffness"), py::arg("slack"), py::arg("avoid_branches"))
      .def_readonly("metrics", &TextureAnimatorData::metrics)
      .def("saved", saved_texture_animator)
      .def_static("loaded", loaded_texture_animator)
      .def("frame", texture_frame, py::arg("directions"), py::arg("frequencies"),
           py::arg("positions"), py::arg("frequencies_v"), py::arg("normals"), py::arg("progress"))
      .def("restart", restart<TextureAnimatorData>);
}

}  // namespace brindle::python
