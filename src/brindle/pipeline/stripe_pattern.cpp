#include "brindle/pipeline/stripe_pattern.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/pattern/point_quality.h"
#include "brindle/surface/areas.h"
#include "brindle/surface/cotangent_weights.h"
#include "brindle/waves/averaged_levels.h"

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

}  // namespace

StripePattern stripe_pattern(const Surface& surface, WaveSet waves, const StripeOptions& options,
                             const Progress& progress) {
  StripePattern result;
  Stopwatch watch;
  progress.report("couple", 0);
  PhaseGraph graph = build_phase_graph(surface.neighborhood, waves, options.phase_shift,
                                       options.weights == EdgeWeights::cotangent
                                           ? cotangent_weights(surface.mesh, *surface.neighborhood)
                                           : std::vector<float>());
  result.milliseconds.couple = watch.lap();

  if (options.solver.solver == Solver::global) graph.mass = positive_areas(surface.mesh);
  if (options.solver.solver == Solver::averaged) {
    attach_averaged_levels(graph, waves, {surface.normals, positive_areas(surface.mesh)},
                           options.phase_shift);
  }
  result.milliseconds.topology = watch.lap();

  result.solution = solve_phases(graph, options.solver, progress);
  result.milliseconds.topology += result.solution.topology_milliseconds;
  result.milliseconds.solve = result.solution.solve_milliseconds;
  graph = {};

  watch.lap();
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

}  // namespace brindle
