#include "brindle/stripe_pattern.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/pipeline/measured_pattern.h"
#include "brindle/pipeline/sewn_faces.h"
#include "brindle/waves/averaged_levels.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

/// Vertex areas, kept above zero so that masses and means are; 1 for points without triangles.
std::vector<float> positive_areas(const Mesh& mesh) {
  if (mesh.triangles.empty()) return std::vector<float>(mesh.vertex_count(), 1.0f);
  std::vector<float> areas = vertex_areas(mesh);
  float largest = 0;
  for (const float area : areas) largest = std::max(largest, area);
  const float floor = std::max(1e-6f * largest, std::numeric_limits<float>::min());
  for (float& area : areas) area = std::max(area, floor);
  return areas;
}

std::vector<float> edge_weights(const Surface& surface, EdgeWeights weights,
                                const Progress& progress) {
  if (weights == EdgeWeights::paper) return {};
  return cotangent_weights(surface.mesh, *surface.neighborhood, progress);
}

SolverData data_for(Solver solver, const Surface& surface, const WaveSet& waves,
                    PhaseShiftKind kind, std::span<const float> edge_weights,
                    const Progress& progress) {
  if (solver == Solver::global) return {positive_areas(surface.mesh), {}};
  if (solver != Solver::averaged) return {};
  constexpr int kLevels = 10;
  return {
      {},
      averaged_levels(*surface.neighborhood, waves, {surface.normals, positive_areas(surface.mesh)},
                      kind, kLevels, edge_weights, progress)};
}

constexpr float kFixed = 1000;  // weight of fixed phases, in multiples of all couplings

bool is_followed(const StripeOptions& options) {
  return !options.last_phases.empty() && options.lambda != 0;
}

bool is_anchored(const StripeOptions& options) {
  return is_followed(options) || !options.fixed_phases.empty();
}

void add_fixed_phases(PhaseGraph& graph, std::span<const Complex> fixed) {
  const std::vector<Complex> others = std::move(graph.anchor);
  anchor_phases(graph, fixed, kFixed);
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (fixed[i] == Complex(0)) graph.anchor[i] = others[i];
  }
}

/// Sets fixed phases exactly, for boundary curves; solvers only approach them.
void set_fixed_phases(const PhaseGraph& graph, std::span<const Complex> fixed,
                      PhaseSolution& solution) {
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i] != Complex(0)) solution.z[i] = fixed[i];
  }
  if (!fixed.empty()) solution.energy = energy(graph, solution.z);
}

void check_anchors(const StripeOptions& options, std::size_t vertices) {
  if (options.last_phases.empty() && options.fixed_phases.empty()) return;
  for (const auto* phases : {&options.last_phases, &options.fixed_phases}) {
    if (!phases->empty()) check_last_phases(*phases, vertices);
  }
  if (options.solver.solver == Solver::multilevel) return;
  throw Error("last and fixed phases are for the solver multilevel, not for " +
              std::string(name_of(options.solver.solver)));
}

void solve_as_graph(const Surface& surface, const WaveSet& waves, const StripeOptions& options,
                    std::span<const float> weights, const Progress& progress,
                    StripePattern& result) {
  JobStages stages(progress, {{"couple", 1}, {"levels", 1}, {"solve", 8}});
  const Progress coupling = stages.begin("couple");
  Stopwatch watch;
  PhaseGraph graph =
      build_phase_graph(surface.neighborhood, waves, options.phase_shift, weights, coupling);
  if (is_followed(options)) anchor_phases(graph, options.last_phases, options.lambda);
  if (!options.fixed_phases.empty()) add_fixed_phases(graph, options.fixed_phases);
  result.milliseconds.couple = watch.lap();
  const SolverData data = data_for(options.solver.solver, surface, waves, options.phase_shift,
                                   weights, stages.begin("levels"));
  result.milliseconds.topology = watch.lap();
  const SolvePhases solve = options.solve ? options.solve : solve_phases;
  result.solution = solve(graph, options.solver, stages.begin("solve"), data);
  set_fixed_phases(graph, options.fixed_phases, result.solution);
  watch.lap();
  if (!is_anchored(options)) sew_faces(surface, waves, result.solution.z);
  result.solution.solve_milliseconds += watch.lap();
}

/// Solves for phases. The multilevel solver couples waves in its own sweep order (couple_waves);
/// all others need a PhaseGraph.
void solve(const Surface& surface, const WaveSet& waves, const StripeOptions& options,
           const Progress& progress, StripePattern& result) {
  progress.report(0);
  Stopwatch watch;
  const std::vector<float> weights = edge_weights(surface, options.weights, progress.part(0, 0.1));
  const double weigh_milliseconds = watch.lap();
  if (!options.solve && !is_anchored(options) && options.solver.solver == Solver::multilevel &&
      options.phase_shift != PhaseShiftKind::common_source) {
    const auto couple = [&](Level& finest) {
      watch.lap();
      couple_waves(finest.layout(), *surface.neighborhood, waves, options.phase_shift, weights,
                   finest.couplings);
      result.milliseconds.couple = watch.lap();
    };
    std::function<void(std::span<Complex>)> sew;
    if (!surface.creases.empty()) sew = [&](std::span<Complex> z) { sew_faces(surface, waves, z); };
    result.solution =
        solve_multilevel(*surface.neighborhood, couple, options.solver, {}, progress, sew);
  } else {
    solve_as_graph(surface, waves, options, weights, progress, result);
  }
  result.milliseconds.couple += weigh_milliseconds;
  result.milliseconds.topology += result.solution.topology_milliseconds;
  result.milliseconds.solve = result.solution.solve_milliseconds;
}

void check_surface(const Surface& surface) {
  const std::size_t vertices = surface.mesh.vertex_count();
  if (surface.neighborhood && surface.neighborhood->node_count() == vertices &&
      surface.normals.size() == vertices) {
    return;
  }
  throw Error("the surface has no neighbours and normals for its " + std::to_string(vertices) +
              " vertices; make it with make_surface");
}

void check_sizes(const Surface& surface, const WaveSet& waves) {
  const std::size_t vertices = surface.mesh.vertex_count();
  if (waves.positions.size() == vertices && waves.directions.size() == vertices &&
      waves.frequencies.size() == vertices) {
    return;
  }
  throw Error("waves: positions, directions and frequencies must have one entry for each of " +
              std::to_string(vertices) + " vertices");
}

/// Changes frequencies within the spacing tolerance.
void relax_frequencies(const Surface& surface, WaveSet& waves, const StripeOptions& options,
                       const Progress& progress, StripePattern& result) {
  Stopwatch watch;
  RelaxedFrequencies relaxed = relaxed_frequencies(surface, waves, options.slack, progress);
  result.frequencies_wanted = std::exchange(waves.frequencies, std::move(relaxed.frequencies));
  result.frequency_change = relaxed.change;
  result.milliseconds.frequency = watch.lap();
}

}  // namespace

void check_tangent_waves(const Surface& surface, const WaveSet& waves) {
  if (surface.normals.size() != surface.mesh.vertex_count()) {
    throw Error("waves: there are " + std::to_string(surface.normals.size()) + " normals for " +
                std::to_string(surface.mesh.vertex_count()) + " vertices");
  }
  check_tangent_waves(surface.normals, waves);
}

void check_tangent_waves(std::span<const Vec3> normals, const WaveSet& waves) {
  const std::size_t vertices = normals.size();
  if (waves.positions.size() != vertices || waves.directions.size() != vertices ||
      waves.frequencies.size() != vertices) {
    throw Error(
        "waves: positions, directions, frequencies and normals must have one entry for each of " +
        std::to_string(vertices) + " vertices");
  }
  check_waves(waves.positions, waves.directions, waves.frequencies);
  check_turnable(normals, waves.directions);
}

namespace {

std::vector<JobStage> stages_of(const StripeOptions& options) {
  std::vector<JobStage> stages = {{"solve", 10}, {"pattern", 3}};
  if (options.slack.relaxes()) stages.insert(stages.begin(), {"frequency", 10});
  return stages;
}

/// Vertices without a wave get the peak phase, independent of the solver's start.
void clear_without_wave(const WaveSet& waves, std::span<Complex> z) {
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (waves.directions[i].isZero(0)) z[i] = kPeak;
  }
}

/// Solves and measures a pattern whose frequencies are final.
void solve_and_measure(const Surface& surface, WaveSet waves, const StripeOptions& options,
                       JobStages& stages, StripePattern& result) {
  solve(surface, waves, options, stages.begin("solve"), result);
  clear_without_wave(waves, result.solution.z);

  Stopwatch watch;
  const Progress measuring = stages.begin("pattern");
  result.waves = std::move(waves);
  measure_pattern(surface, options.slack.branch_penalty, result, measuring);
  result.milliseconds.pattern = watch.lap();
  stages.finish();
}

}  // namespace

StripePattern stripe_pattern(const Surface& surface, WaveSet waves, const StripeOptions& options,
                             const Progress& progress) {
  StripePattern result;
  result.phase_shift = options.phase_shift;
  check_surface(surface);
  check_sizes(surface, waves);
  check_waves(waves.positions, waves.directions, waves.frequencies);
  check_tangent(surface.normals, waves.directions);
  check_fineness(*surface.neighborhood, waves.positions, waves.directions, waves.frequencies);
  check_anchors(options, surface.mesh.vertex_count());
  check_slack(options.slack, surface.mesh.vertex_count());
  JobStages stages(progress, stages_of(options));
  if (options.slack.relaxes()) {
    relax_frequencies(surface, waves, options, stages.begin("frequency"), result);
  }
  solve_and_measure(surface, std::move(waves), options, stages, result);
  return result;
}

StripePattern resolve_with_frequencies(const Surface& surface, WaveSet waves,
                                       const StripePattern& before, const StripeOptions& options,
                                       const Progress& progress) {
  StripePattern result;
  result.phase_shift = options.phase_shift;
  check_anchors(options, surface.mesh.vertex_count());
  result.frequencies_wanted = before.frequencies_wanted;
  result.frequency_change = before.frequency_change;
  result.milliseconds.frequency = before.milliseconds.frequency;
  JobStages stages(progress, {{"solve", 10}, {"pattern", 3}});
  solve_and_measure(surface, std::move(waves), options, stages, result);
  return result;
}

StripePattern stripe_pattern(const Surface& surface, DirectionField field,
                             FrequencyField frequencies, const StripeOptions& options,
                             const Progress& progress) {
  return stripe_pattern(surface, {surface.mesh.positions, std::move(field), std::move(frequencies)},
                        options, progress);
}

StripePattern stripe_pattern(const Surface& surface, DirectionField field, float frequency,
                             const StripeOptions& options, const Progress& progress) {
  return stripe_pattern(surface, std::move(field),
                        constant_frequency_field(frequency, surface.mesh.vertex_count()), options,
                        progress);
}

}  // namespace brindle
