#include "piece_waves.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "brindle/base/stopwatch.h"
#include "brindle/distributed/rank_surface.h"
#include "brindle/distributed/selection.h"
#include "piece_fields.h"
#include "piece_frequencies.h"
#include "piece_slack.h"

namespace brindle::tool {
namespace {

/// Of several ranks the median is one of floats.
void measure_edges(Communicator& ranks, std::vector<double>& edges, WaveFigures& figures) {
  const std::size_t count = ranks.sum(edges.size());
  if (count == 0) return;
  double least = std::numeric_limits<double>::infinity();
  for (const double number : edges) least = std::min(least, number);
  figures.edges_per_period_min = -ranks.greatest(-least);
  if (ranks.size() > 1) {
    const std::vector<float> floats(edges.begin(), edges.end());
    figures.edges_per_period_median = static_cast<double>(kth_smallest(ranks, floats, count / 2));
    return;
  }
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  figures.edges_per_period_median = *middle;
}

/// The figures of all ranks' waves.
WaveFigures measure_waves(Communicator& ranks, const DistributedSurface& surface,
                          const WaveSet& of_piece) {
  const RankSurface& own = surface.rank_surface();
  const Surface nodes{own.mesh, own.graph.adjacency, own.normals};
  WaveSet waves;
  waves.directions.resize(own.graph.own, Vec3::Zero());
  waves.frequencies.resize(own.graph.own, 1);
  for (std::size_t p = 0; p < of_piece.directions.size(); ++p) {
    const Index v = own.vertex_of_piece[p];
    if (v >= own.graph.own) continue;
    waves.directions[v] = of_piece.directions[p];
    waves.frequencies[v] = of_piece.frequencies[p];
  }
  WaveTally tally = tally_waves(nodes, waves);
  tally.used = ranks.sum(tally.used);
  tally.without_wave = ranks.sum(tally.without_wave);
  tally.frequency_sum = ranks.sum(tally.frequency_sum);
  tally.frequency_max = ranks.greatest(tally.frequency_max);
  tally.frequency_min = -ranks.greatest(-tally.frequency_min);
  WaveFigures figures = figures_of(tally, surface.diagonal());
  measure_edges(ranks, tally.edges_per_period, figures);
  return figures;
}

}  // namespace

WantedArrays wanted_arrays(const WaveOptions& options) {
  WantedArrays wanted;
  if (!options.arrays.mesh.empty()) return wanted;  // they are of another file
  if (is_array(options.field)) wanted.names.push_back(parse_array("--field", options.field));
  const ArrayOptions& arrays = options.arrays;
  if (!arrays.frequency.empty()) wanted.names.push_back(arrays.frequency);
  if (is_array(arrays.frequency_by)) {
    wanted.names.push_back(parse_array("--frequency-by", arrays.frequency_by));
  }
  return wanted;
}

PieceWaves make_piece_waves(Communicator& ranks, const DistributedSurface& surface,
                            const ReadPiece& read, const PieceWaveOptions& wanted,
                            JobListener& listener) {
  const WaveOptions& options = wanted.waves;
  Stopwatch watch;
  listener.stage("direction field");
  PieceWaves made;
  PieceField field = make_piece_field(ranks, surface, read, wanted);
  const float turn_deg = options.rotate_deg + (options.along ? 90.0f : 0.0f);
  if (turn_deg != 0) {
    field.directions =
        rotated(field.directions, surface.normals(), turn_deg * std::numbers::pi_v<float> / 180);
  }
  field.missing.too_far = field.arrays->drop_too_far(field.directions);
  choose_piece_frequencies(ranks, surface, read, options, field);
  listener.note(field.notes);
  made.waves = {read.piece.mesh.positions, std::move(field.directions),
                std::move(field.frequencies)};
  made.field_rows_nonfinite = field.rows_nonfinite;
  made.figures = measure_waves(ranks, surface, made.waves);
  made.figures.missing = field.missing;
  ranks.together([&] { check_waves(made.figures, source_of(options)); });
  listener.note(warnings(made.figures, source_of(options)));
  made.milliseconds = watch.lap();
  return made;
}

DistributedOptions animator_options(Communicator& ranks, const SolvingOptions& solving,
                                    HierarchyBounds bounds, const ReadPiece& read,
                                    const DistributedSurface& surface) {
  DistributedOptions options;
  options.solver = FrameSolver::multilevel;
  options.gather_below = bounds.gather_below;
  options.plan_below = bounds.plan_below;
  options.phase_shift = solving.stripes.phase_shift;
  options.weights = solving.stripes.weights;
  options.sweeps = solving.stripes.solver.sweeps;
  options.cycles = solving.stripes.solver.cycles;
  options.slack = piece_slack(ranks, solving.slack, read, surface.vertex_count());
  return options;
}

}  // namespace brindle::tool
