#include "brindle/stripe_pattern.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/geometry/areas.h"
#include "brindle/geometry/cotangent_weights.h"
#include "brindle/geometry/mesh_edges.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/pattern/point_quality.h"
#include "brindle/pattern/point_sampling.h"
#include "brindle/pattern/sampling.h"
#include "brindle/pattern/stripe_curves.h"
#include "brindle/phases/multilevel_waves.h"
#include "brindle/waves/averaged_levels.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

/// Vertex areas, never zero: a vertex without area must not make a mass or a mean vanish. Points
/// without triangles count alike.
std::vector<float> positive_areas(const Mesh& mesh) {
  if (mesh.triangles.empty()) return std::vector<float>(mesh.vertex_count(), 1.0f);
  std::vector<float> areas = vertex_areas(mesh);
  float largest = 0;
  for (const float area : areas) largest = std::max(largest, area);
  const float floor = std::max(1e-6f * largest, std::numeric_limits<float>::min());
  for (float& area : areas) area = std::max(area, floor);
  return areas;
}

std::vector<float> edge_weights(const Surface& surface, EdgeWeights weights) {
  if (weights == EdgeWeights::paper) return {};
  return cotangent_weights(surface.mesh, *surface.neighborhood);
}

SolverData data_for(Solver solver, const Surface& surface, const WaveSet& waves,
                    PhaseShiftKind kind, std::span<const float> edge_weights) {
  if (solver == Solver::global) return {positive_areas(surface.mesh), {}};
  if (solver != Solver::averaged) return {};
  constexpr int kLevels = 10;
  return {
      {},
      averaged_levels(*surface.neighborhood, waves, {surface.normals, positive_areas(surface.mesh)},
                      kind, kLevels, edge_weights)};
}

bool is_anchored(const StripeOptions& options) {
  return !options.last_phases.empty() && options.lambda != 0;
}

void check_anchors(const StripeOptions& options, std::size_t vertices) {
  if (options.last_phases.empty()) return;
  check_last_phases(options.last_phases, vertices);
  if (options.solver.solver == Solver::multilevel) return;
  throw Error("last phases are for the solver multilevel, not for " +
              std::string(name_of(options.solver.solver)));
}

void solve_as_graph(const Surface& surface, const WaveSet& waves, const StripeOptions& options,
                    std::span<const float> weights, const Progress& progress,
                    StripePattern& result) {
  Stopwatch watch;
  PhaseGraph graph = build_phase_graph(surface.neighborhood, waves, options.phase_shift, weights);
  if (is_anchored(options)) anchor_phases(graph, options.last_phases, options.lambda);
  result.milliseconds.couple = watch.lap();
  const SolverData data =
      data_for(options.solver.solver, surface, waves, options.phase_shift, weights);
  result.milliseconds.topology = watch.lap();
  const SolvePhases solve = options.solve ? options.solve : solve_phases;
  result.solution = solve(graph, options.solver, progress, data);
}

/// From waves to phases. The multilevel solver needs no phase graph between them.
void solve(const Surface& surface, const WaveSet& waves, const StripeOptions& options,
           const Progress& progress, StripePattern& result) {
  Stopwatch watch;
  const std::vector<float> weights = edge_weights(surface, options.weights);
  const double weigh_milliseconds = watch.lap();
  if (!options.solve && !is_anchored(options) && options.solver.solver == Solver::multilevel &&
      options.phase_shift != PhaseShiftKind::common_source) {
    WaveSolution solved = solve_multilevel_waves(*surface.neighborhood, waves, options.phase_shift,
                                                 weights, options.solver, progress);
    result.solution = std::move(solved.solution);
    result.milliseconds.couple = solved.couple_milliseconds;
  } else {
    solve_as_graph(surface, waves, options, weights, progress, result);
  }
  result.milliseconds.couple += weigh_milliseconds;
  result.milliseconds.topology += result.solution.topology_milliseconds;
  result.milliseconds.solve = result.solution.solve_milliseconds;
}

}  // namespace

void check_tangent_waves(const Surface& surface, const WaveSet& waves) {
  const std::size_t vertices = surface.mesh.vertex_count();
  if (waves.positions.size() != vertices || waves.directions.size() != vertices ||
      waves.frequencies.size() != vertices || surface.normals.size() != vertices) {
    throw Error(
        "waves: positions, directions, frequencies and normals must have one entry for each of " +
        std::to_string(vertices) + " vertices");
  }
  check_waves(waves.positions, waves.directions, waves.frequencies);
  constexpr float kSine = 0.07f;
  for (std::size_t i = 0; i < vertices; ++i) {
    if (std::abs(surface.normals[i].dot(waves.directions[i])) <= kSine) continue;
    throw Error("waves: the direction of vertex " + std::to_string(i) +
                " is not tangent to the surface; project it with tangent_directions");
  }
}

StripePattern stripe_pattern(const Surface& surface, WaveSet waves, const StripeOptions& options,
                             const Progress& progress) {
  StripePattern result;
  result.phase_shift = options.phase_shift;
  check_anchors(options, surface.mesh.vertex_count());
  progress.report("couple", 0);
  solve(surface, waves, options, progress, result);

  Stopwatch watch;
  progress.report("pattern", 0);
  result.corners =
      corner_phases(surface.mesh.triangles, waves, result.solution.z, options.phase_shift);
  result.quality = surface.mesh.triangles.empty()
                       ? measure_point_quality(*surface.neighborhood, surface.normals, waves,
                                               result.solution.z, options.phase_shift)
                       : measure_quality(surface.mesh, waves, result.corners);
  result.milliseconds.pattern = watch.lap();
  result.waves = std::move(waves);
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

namespace {

void check_belongs(const Surface& surface, const StripePattern& pattern) {
  if (pattern.solution.z.size() == surface.mesh.vertex_count() &&
      pattern.corners.size() == surface.mesh.triangle_count()) {
    return;
  }
  throw Error("a pattern of " + std::to_string(pattern.solution.z.size()) + " vertices and " +
              std::to_string(pattern.corners.size()) + " triangles was not made for a surface of " +
              std::to_string(surface.mesh.vertex_count()) + " and " +
              std::to_string(surface.mesh.triangle_count()));
}

LiftedWaves lifted(const Surface& surface, const MeshEdges& edges, const StripePattern& pattern) {
  return LiftedWaves({surface.mesh, edges, surface.normals, pattern.waves, pattern.solution.z,
                      pattern.phase_shift});
}

}  // namespace

StripeCurves stripe_curves(const Surface& surface, const StripePattern& pattern,
                           const CurveOptions& options) {
  check_belongs(surface, pattern);
  if (surface.mesh.triangles.empty()) throw Error("curves need triangles; points have none");
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  return stripe_curves(lifted(surface, edges, pattern), options);
}

std::vector<Sample> stripe_samples(const Surface& surface, const StripePattern& u,
                                   const StripePattern& v) {
  check_belongs(surface, u);
  check_belongs(surface, v);
  std::vector<Sample> samples;
  if (surface.mesh.triangles.empty()) {
    samples = point_samples(*surface.neighborhood, surface.normals, {u.waves, u.solution.z},
                            {v.waves, v.solution.z});
  } else {
    const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
    const LiftedWaves lifted_u = lifted(surface, edges, u), lifted_v = lifted(surface, edges, v);
    samples = wave_samples(surface.mesh, surface.normals, sampled_waves(lifted_u),
                           sampled_waves(lifted_v));
  }
  drop_doubles(samples);
  return samples;
}

}  // namespace brindle
