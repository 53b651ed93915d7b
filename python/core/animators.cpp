#include <algorithm>
#include <atomic>

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/recipe/refusals.h"
#include "brindle/saved.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_animator.h"
#include "brindle/waves/parsed_words.h"
#include "frame_waves.h"
#include "given_options.h"
#include "job.h"
#include "pattern_data.h"
#include "words.h"

namespace brindle::python {
namespace {

// One frame at a time; concurrent calls are rejected.
struct AnimatorData {
  SurfacePointer surface;
  StripeAnimator animator;
  MovingNormals normals;
  std::vector<float> frequencies;  // of the last frame, with slack
  double phase_step = 0;
  bool unchanged = false;
  FrameMilliseconds milliseconds;
  double topology_milliseconds = 0;
  std::atomic<bool> busy{false};

  AnimatorData(SurfacePointer on, StripeAnimator with)
      : surface(std::move(on)), animator(std::move(with)), normals(surface->surface) {}
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

struct FieldAnimatorData {
  SurfacePointer surface;
  SmoothFieldAnimator animator;
  std::atomic<bool> busy{false};

  FieldAnimatorData(SurfacePointer on, const SmoothFieldAnimatorOptions& options)
      : surface(std::move(on)), animator(until_interrupted([&](const Progress& progress) {
          return SmoothFieldAnimator(surface->surface, options, progress);
        })) {}
};

py::array field_frame(FieldAnimatorData& data, py::handle vertices, py::handle directions,
                      py::handle weights, const py::object& progress) {
  const OneAtATime alone(data.busy, "this animator");
  refuse_masked(vertices, "vertices");
  const Table numbers = table_of(vertices, "vertices");
  const std::size_t count = numbers.is_number ? 1 : numbers.view.rows();
  const Table ways = table_of(directions, "directions");
  const Table strengths = table_of(weights, "weights");
  for (const auto& [table, what] : {std::pair(&ways, "directions"), {&strengths, "weights"}}) {
    if (!table->is_number) check_rows(table->array, count, what, "anchors (vertices)");
  }
  const std::vector<Vec3> vectors = vectors_of(ways.view, "directions");
  const std::vector<float> weight = numbers_of(strengths.view, "weights");
  const auto kind = numbers.array.dtype().kind();
  if (kind == 'f' && numbers.view.rows() > 0) {
    throw py::type_error("vertices: expected whole numbers");
  }
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> numbers_64(
      numbers.array);
  if (numbers.array.ndim() > 1) {
    throw Error("vertices: expected an array (k,), got one of " +
                std::to_string(numbers.array.ndim()) + " dimensions");
  }
  const auto all = static_cast<std::int64_t>(data.surface->surface.mesh.vertex_count());
  std::vector<FieldAnchor> anchors;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t vertex = numbers_64.data()[i];
    if (vertex < 0 || vertex >= all) {
      throw Error("vertices: " + std::to_string(vertex) + " is none of " + std::to_string(all) +
                  ", numbered from 0");
    }
    anchors.push_back(
        {static_cast<Index>(vertex), vectors[i], strengths.is_number ? weight.front() : weight[i]});
  }
  return owned(Job(progress).run([&](const Progress& reports) {
    const std::span<const Vec3> field = data.animator.frame(anchors, reports);
    return std::vector<Vec3>(field.begin(), field.end());
  }));
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

void bind_animator(py::module_& module) {
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
      .def("restart",
           [](AnimatorData& data) {
             const OneAtATime alone(data.busy, "this animator");
             data.animator.restart();
           })
      .def(
          "set_phases",
          [](AnimatorData& data, py::handle phases) {
            const OneAtATime alone(data.busy, "this animator");
            data.animator.set_last_phases(phases_of(phases, data.surface->surface.mesh, "phases"));
          },
          py::arg("phases"));
}

}  // namespace

void bind_animators(py::module_& module) {
  bind_animator(module);
  py::class_<FieldAnimatorData>(module, "FieldAnimator")
      .def(py::init([](const SurfacePointer& surface, int symmetry, float lambda, int sweeps) {
             return std::make_unique<FieldAnimatorData>(
                 surface, SmoothFieldAnimatorOptions{symmetry, lambda, sweeps});
           }),
           py::arg("surface").none(false), py::arg("symmetry"), py::arg("stiffness"),
           py::arg("sweeps"))
      .def("frame", field_frame, py::arg("vertices"), py::arg("directions"), py::arg("weights"),
           py::arg("progress"));
}

}  // namespace brindle::python
