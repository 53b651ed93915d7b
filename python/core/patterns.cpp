#include <algorithm>
#include <limits>

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/base/array_rows.h"
#include "brindle/carried_phases.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/pattern_arrays.h"
#include "brindle/phases/parsed_words.h"
#include "brindle/quality.h"
#include "brindle/recipe/json_text.h"
#include "brindle/recipe/refusals.h"
#include "brindle/recipe/solving_rows.h"
#include "brindle/recipe/wave_rows.h"
#include "brindle/threads.h"
#include "brindle/waves/parsed_words.h"
#include "job.h"
#include "pattern_data.h"
#include "stored.h"
#include "words.h"

namespace brindle::python {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// The phases to continue, and their part of a report.
struct StyleBindings {
  std::vector<Complex> z;
  brindle::FollowedReport report;
};

StyleBindings follow(const StripesData& last, const SurfaceData& surface, const WaveSet& waves,
                     const std::string& match, float lambda) {
  const Mesh& mesh = surface.surface.mesh;
  const LastPattern pattern{last.surface->surface.mesh, last.pattern.waves,
                            last.pattern.solution.z};
  const bool by_number = matches_by_number(pattern.mesh, mesh, match);
  StyleBindings followed;
  followed.z = by_number ? matched_phases(pattern, waves) : carried_phases(pattern, mesh, waves);
  followed.report.previous = last.surface->name;
  followed.report.lambda = lambda;
  followed.report.matched_by = by_number ? "number" : "position";
  return followed;
}

void tell_step(const StyleBindings& followed, StripesData& made) {
  made.followed = followed.report;
  const PhaseStep step = phase_step(made.pattern.waves, made.pattern.solution.z, followed.z);
  made.followed->vertices_unmatched = step.unmatched;
  made.followed->phase_step = step.mean;
}

// Joined vertices get the wave of their partner, as in files.
void copy_to_joined(StripesData& made) {
  const std::vector<Index>& partners = made.surface->partners;
  WaveSet& waves = made.pattern.waves;
  FrequencyField& wanted = made.pattern.frequencies_wanted;
  for (std::size_t v = 0; v < partners.size(); ++v) {
    waves.directions[v] = waves.directions[partners[v]];
    waves.frequencies[v] = waves.frequencies[partners[v]];
    if (!wanted.empty()) wanted[v] = wanted[partners[v]];
    made.pattern.solution.z[v] = made.pattern.solution.z[partners[v]];
  }
}

StripesPointer stripes(const SurfacePointer& surface, py::handle directions, py::handle count,
                       py::handle frequency, const FieldOrigin& origin, const Solving& solving,
                       const StripesPointer& previous, const std::string& match,
                       const py::object& progress) {
  WavesIn in = waves_of_arrays(*surface, directions, count, frequency, origin);
  return Job(progress, solving.threads).run([&](const Progress& reports) {
    StripeOptions options = solving.stripes;
    std::optional<StyleBindings> followed;
    if (previous) {
      followed = follow(*previous, *surface, in.waves, match, options.lambda);
      options.last_phases = followed->z;
    }
    PatternResult pattern = saying_in_pythons_words([&] {
      return pattern_of(surface->surface, std::move(in.waves),
                        {PatternKind::stripes, options, solving.fabrication}, reports);
    });
    StripesPointer made = stripes_data(surface, std::get<StripePattern>(std::move(pattern.of)),
                                       in.prepared, options.solver.solver);
    made->fabrication = std::move(pattern.fabrication);
    if (followed) {
      tell_step(*followed, *made);
      made->followed->field_turned_deg = origin.field_turned_deg;
    }
    copy_to_joined(*made);
    return made;
  });
}

// Measures existing phases, such as those of an animator or a file.
StripesPointer stripes_from_phases(const SurfacePointer& surface, py::handle phases,
                                   py::handle directions, py::handle count, py::handle frequency,
                                   const FieldOrigin& origin, const Solving& solving) {
  std::vector<Complex> z = phases_of(phases, surface->surface.mesh, "phases");
  WavesIn in = waves_of_arrays(*surface, directions, count, frequency, origin, z);
  StripeOptions options = solving.stripes;
  options.solve = [&](const PhaseGraph& graph, const SolverOptions&, const Progress&,
                      const SolverData&) {
    PhaseSolution solution;
    anchor_phases(*std::make_unique<PhaseGraph>(graph), z,
                  1);                                    // throws unless unit complex numbers
    std::ranges::replace(z, Complex(0), Complex(0, 1));  // as solvers leave vertices without a wave
    solution.energy = energy(graph, z);
    solution.z = std::move(z);
    return solution;
  };
  return without_lock([&] {
    StripesPointer made =
        stripes_data(surface, stripe_pattern(surface->surface, std::move(in.waves), options),
                     in.prepared, Solver::multilevel);
    copy_to_joined(*made);
    return made;
  });
}

py::array corner_phases_array(const StripesData& data) {
  return array_owning(brindle::corner_phases_of(data.pattern, "corner_phase"));
}

py::dict point_arrays(const StripesData& data) {
  std::vector<DataArray> arrays;
  const Mesh& mesh = data.surface->surface.mesh;
  brindle::add_waves(
      arrays, {data.pattern.waves, data.pattern.frequencies_wanted, data.pattern.solution.z, ""},
      kNan,
      data.surface->is_points() ? std::vector<float>()
                                : brindle::branches_at_vertices(mesh, data.pattern.corners));
  brindle::add_support(arrays, data.prepared.support);
  copy_from_partners(arrays, data.surface->partners);
  arrays.push_back(make_data_array("original_id", 1, data.surface->original_ids));
  brindle::add_turn(arrays, data.prepared.turn_deg, mesh.vertex_count());
  return dict_owning(std::move(arrays));
}

py::dict cell_arrays(const StripesData& data) {
  if (data.surface->is_points()) return {};
  return dict_owning({brindle::branches_in_triangles(data.pattern, "branch"),
                      brindle::corner_phases_of(data.pattern, "corner_phase")});
}

template <class Number, class Value>
py::array per_triangle(const StripesData& data, const Value& value) {
  std::vector<Number> values;
  values.reserve(data.pattern.corners.size());
  for (const CornerPhases& corners : data.pattern.corners) values.push_back(value(corners));
  return owned(std::move(values));
}

py::array branches_of(const StripesData& data) {
  return per_triangle<std::int8_t>(data, [](const CornerPhases& corners) {
    const bool ends =
        corners.kind == TriangleKind::branch || corners.kind == TriangleKind::field_singularity;
    return static_cast<std::int8_t>(ends ? 1 : 0);
  });
}

py::array kinds_of(const StripesData& data) {
  return per_triangle<std::uint8_t>(
      data, [](const CornerPhases& corners) { return static_cast<std::uint8_t>(corners.kind); });
}

py::array branch_indices_of(const StripesData& data) {
  return per_triangle<std::int8_t>(
      data, [](const CornerPhases& corners) { return corners.branch_index; });
}

py::array angle_errors_of(const StripesData& data) {
  return owned(without_lock([&] {
    return angle_errors_deg(data.surface->surface.mesh, data.pattern.waves, data.pattern.corners);
  }));
}

std::string report_of(const StripesData& data, const std::string& invocation) {
  brindle::Report report =
      brindle::make_report(data.surface->surface, data.prepared, data.pattern, data.solver);
  report.threads = data.threads;
  report.followed = data.followed;
  brindle::add_to_json(data.fabrication, report.fabrication);
  report.invocation = nlohmann::ordered_json::parse(invocation);
  return brindle::json_text(brindle::to_json(report));
}

// The loops, winding numbers and branches in the tool's report of curves.
std::string fabrication_of(const StripesData& data) {
  FabricationMetrics metrics = data.fabrication;
  without_lock([&] { brindle::measure_windings(data.surface->surface, data.pattern, metrics); });
  auto json = nlohmann::ordered_json::object();
  brindle::add_to_json(metrics, json);
  return json.dump();
}

// Lines about likely mistakes.
std::string warnings_of(const StripesData& data, const std::string& source) {
  return brindle::warnings(data.prepared.metrics, source) +
         brindle::quality_warning(data.prepared.metrics, data.pattern.quality,
                                  data.surface->surface.mesh.triangle_count());
}

void bind_stripes(py::module_& module) {
  py::class_<StripesData, StripesPointer> type(module, "Stripes");
  bind_pickle(type);
  def_rows(
      type, "phases", [](const auto& data) -> auto& { return data.pattern.solution.z; });
  def_rows(
      type, "frequency", [](const auto& data) -> auto& { return data.pattern.waves.frequencies; });
  def_rows(
      type, "frequency_wanted", [](const auto& data) -> auto& {
        const StripePattern& pattern = data.pattern;
        return pattern.frequencies_wanted.empty() ? pattern.waves.frequencies
                                                  : pattern.frequencies_wanted;
      });
  def_rows(
      type, "directions", [](const auto& data) -> auto& { return data.pattern.waves.directions; });
  type.def_readonly("surface", &StripesData::surface)
      .def_property_readonly("turn_deg",
                             [](const StripesData& data) { return data.prepared.turn_deg; })
      .def("cancelled_branches",
           [](const StripesData& data) {
             return cancelled_branches_of(data.fabrication.cancelled_branches);
           })
      .def("corner_phases", corner_phases_array)
      .def("point_arrays", point_arrays)
      .def("cell_arrays", cell_arrays)
      .def("branches", branches_of)
      .def("kinds", kinds_of)
      .def("branch_indices", branch_indices_of)
      .def("angle_errors", angle_errors_of)
      .def("report", report_of, py::arg("invocation"))
      .def("fabrication", fabrication_of)
      .def("warnings", warnings_of, py::arg("source"));
}

}  // namespace

StripesPointer stripes_data(const SurfacePointer& surface, StripePattern&& pattern,
                            const PreparationMetrics& prepared, Solver solver) {
  auto made = std::make_shared<StripesData>();
  made->surface = surface;
  made->pattern = std::move(pattern);
  made->prepared = prepared;
  made->solver = solver;
  made->threads = ThreadLimit::current();
  return made;
}

py::object cancelled_branches_of(const std::optional<CancelledBranches>& merged) {
  if (!merged) return py::none();
  return py::dict("pairs"_a = merged->pairs, "branches_before"_a = merged->branches_before,
                  "branches_after"_a = merged->branches_after,
                  "energy_before"_a = merged->energy_before,
                  "energy_after"_a = merged->energy_after);
}

Slack slack_of(py::handle slack, py::handle branch_penalty, const Mesh& mesh) {
  Slack result;
  if (!slack.is_none()) {
    const Table table = table_of(slack, "slack");
    if (!table.is_number) check_rows(table.array, mesh, "slack");
    std::vector<float> numbers = numbers_of(table.view, "slack");
    if (table.is_number) {
      result.everywhere = numbers.front();
    } else {
      result.by_vertex = std::move(numbers);
    }
  }
  if (!branch_penalty.is_none()) {
    const Table table = table_of(branch_penalty, "avoid_branches");
    check_rows(table.array, mesh, "avoid_branches");
    result.branch_penalty = numbers_of(table.view, "avoid_branches");
  }
  return result;
}

namespace {

// Each option is checked by the first function that rejects it.
void check_solving(const Solving& solving, const GivenOptions& options, bool is_stripes,
                   bool points) {
  const brindle::IsGiven given = options.is_given();
  const SolverOptions& solver = solving.stripes.solver;
  saying_in_pythons_words([&] {
    brindle::check_avoid_branches(given, solving.stripes.slack.relaxes());
    brindle::check_solver_options(given, solver.solver, solver.cycles);
    brindle::check_following(given, given("--previous"), solver.solver);
    brindle::check_fabrication(solving.fabrication, solver.solver);
    if (!is_stripes) brindle::check_fabrication_of_textures(given);
    if (!points) return;
    brindle::check_fabrication_on_points(given);
    brindle::check_triangle_options(given);
  });
  if (solver.solver == Solver::global) use_unforkable(UnforkableWork::global_solver);
}

Solving solving_of(const py::dict& given, py::handle slack, py::handle branch_penalty,
                   const SurfaceData& surface, bool is_stripes) {
  Solving solving;
  GivenOptions options(given);
  options("--solver", solving.stripes.solver.solver, parse_solver);
  visit_solving(solving.stripes, options);
  visit_fabrication(solving.fabrication, options);
  options("--lambda", solving.stripes.lambda);
  options("--threads", solving.threads);
  std::vector<std::pair<std::string, int>> windings;
  options("--winding", windings);
  for (const auto& [loop, periods] : windings)
    solving.fabrication.windings.push_back({loop, periods});
  solving.stripes.slack = slack_of(slack, branch_penalty, surface.surface.mesh);
  if (!branch_penalty.is_none()) options.add("--avoid-branches");
  check_solving(solving, options, is_stripes, surface.is_points());
  return solving;
}

// The weight is a word for the data's own, or numbers.
void smooth_data(FieldOrigin& origin, const py::dict& given, int symmetry, bool frequency_varies,
                 py::handle weight) {
  const GivenOptions options(given);
  options("--field-smoothing", origin.smoothing.periods);
  options("--frequency-smoothing", origin.frequency_smoothing.periods);
  options("--fill", origin.smoothing.fill);
  options("--fill", origin.frequency_smoothing.fill);
  options("--field-singularities", origin.smoothing.singularities);
  options("--hold-out", origin.smoothing.hold_out);
  origin.smoothing.symmetry = symmetry;
  saying_in_pythons_words([&] {
    brindle::check_field_smoothing(options.is_given(),
                                   {origin.smoothing.periods, origin.frequency_smoothing.periods,
                                    origin.measured, symmetry == 4, frequency_varies});
  });
  if (py::isinstance<py::str>(weight)) {
    origin.weight.word = py::cast<std::string>(weight);
  } else if (!weight.is_none()) {
    origin.weight.values = numbers_of(table_of(weight, "field_weight").view, "field_weight");
    check_not_empty(origin.weight.values.size(), "field_weight");
  }
}

}  // namespace

void bind_solving(py::module_& module) {
  py::class_<Solving>(module, "Solving")
      .def(py::init(&solving_of), py::arg("given"), py::arg("slack").none(true),
           py::arg("avoid_branches").none(true), py::arg("surface"), py::arg("is_stripes"));
  py::class_<FieldOrigin>(module, "FieldOrigin")
      .def(py::init<>())
      .def_readwrite("source", &FieldOrigin::source)
      .def_readwrite("rows_nonfinite", &FieldOrigin::rows_nonfinite)
      .def_readwrite("turn_deg", &FieldOrigin::turn_deg)
      .def_readwrite("field_turned_deg", &FieldOrigin::field_turned_deg)
      .def_readwrite("tensor", &FieldOrigin::tensor)
      .def_readwrite("measured", &FieldOrigin::measured)
      .def("set_data",
           [](FieldOrigin& origin, const std::string& name, py::handle array, bool of_triangles) {
             origin.data = {data_array_of(name, array), of_triangles};
           })
      .def("smooth_data", smooth_data, py::arg("given"), py::arg("symmetry"),
           py::arg("frequency_varies"), py::arg("weight"))
      .def(
          "see_frequencies_like",
          [](FieldOrigin& origin, const FieldOrigin& other) {
            origin.frequency_smoothing = other.frequency_smoothing;
          },
          py::arg("other"))
      .def_readwrite("milliseconds", &FieldOrigin::milliseconds);
}

void bind_patterns(py::module_& module) {
  bind_stripes(module);
  module.def("stripes", stripes, py::arg("surface").none(false), py::arg("directions"),
             py::arg("stripes"), py::arg("frequency"), py::arg("origin"), py::arg("solving"),
             py::arg("previous").none(true), py::arg("match"), py::arg("progress"));
  module.def("stripes_from_phases", stripes_from_phases, py::arg("surface").none(false),
             py::arg("phases"), py::arg("directions"), py::arg("stripes"), py::arg("frequency"),
             py::arg("origin"), py::arg("solving"));
}

}  // namespace brindle::python
