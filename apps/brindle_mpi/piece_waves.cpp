#include "piece_waves.h"

#include <algorithm>
#include <numbers>
#include <span>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/distributed/rank_surface.h"
#include "brindle/distributed/selection.h"

namespace brindle::tool {
namespace {

DirectionField make_directions(const DistributedSurface& surface, const WaveOptions& options) {
  if (options.direction) return projected_direction_field(*options.direction, surface.normals());
  if (!is_smooth(options)) return curvature_direction_field(surface, options.curvature_direction);
  SmoothFieldOptions smooth;
  smooth.curvature_anchor = curvature_anchor(options);
  smooth.curvature_direction = options.curvature_direction;
  return smooth_direction_field(surface, smooth);
}

/// The figures of all ranks' waves.
WaveFigures measure_waves(Communicator& ranks, const DistributedSurface& surface,
                          std::span<const Vec3> directions, float frequency) {
  const RankSurface& own = surface.rank_surface();
  const Surface nodes{own.mesh, own.graph.adjacency, own.normals};
  WaveSet waves;
  waves.directions.resize(own.graph.own, Vec3::Zero());
  for (std::size_t p = 0; p < directions.size(); ++p) {
    const Index v = own.vertex_of_piece[p];
    if (v < own.graph.own) waves.directions[v] = directions[p];
  }
  waves.frequencies.assign(own.graph.own, frequency);
  WaveTally tally = tally_waves(nodes, waves);
  tally.used = ranks.sum(tally.used);
  tally.without_wave = ranks.sum(tally.without_wave);
  tally.frequency_sum = ranks.sum(tally.frequency_sum);
  tally.frequency_min = tally.frequency_max = static_cast<double>(frequency);
  WaveFigures figures = figures_of(tally, surface.diagonal());
  const std::vector<float> edges(tally.edges_per_period.begin(), tally.edges_per_period.end());
  const std::size_t count = ranks.sum(edges.size());
  if (count == 0) return figures;
  figures.edges_per_period_min = static_cast<double>(kth_smallest(ranks, edges, 0));
  figures.edges_per_period_median = static_cast<double>(kth_smallest(ranks, edges, count / 2));
  return figures;
}

}  // namespace

PieceWaves make_piece_waves(Communicator& ranks, const DistributedSurface& surface,
                            std::vector<Vec3> positions, const WaveOptions& options,
                            JobListener& listener) {
  Stopwatch watch;
  listener.stage("direction field");
  PieceWaves made;
  DirectionField directions = make_directions(surface, options);
  const float turn_deg = options.rotate_deg + (options.along ? 90.0f : 0.0f);
  if (turn_deg != 0) {
    directions = rotated(directions, surface.normals(), turn_deg * std::numbers::pi_v<float> / 180);
  }
  const float frequency = constant_frequency(static_cast<float>(surface.diagonal()), options);
  made.figures = measure_waves(ranks, surface, directions, frequency);
  ranks.together([&] { check_waves(made.figures, source_of(options)); });
  listener.note(warnings(made.figures, source_of(options)));
  const std::size_t vertices = positions.size();
  made.waves = {std::move(positions), std::move(directions),
                constant_frequency_field(frequency, vertices)};
  made.milliseconds = watch.lap();
  return made;
}

DistributedOptions animator_options(const SolvingOptions& solving) {
  DistributedOptions options;
  options.solver = FrameSolver::multilevel;
  options.phase_shift = solving.stripes.phase_shift;
  options.sweeps = solving.stripes.solver.sweeps;
  options.cycles = solving.stripes.solver.cycles;
  return options;
}

}  // namespace brindle::tool
