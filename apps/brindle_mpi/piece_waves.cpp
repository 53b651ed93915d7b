#include "piece_waves.h"

#include <algorithm>
#include <memory>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>

#include "brindle/array_field.h"
#include "brindle/base/stopwatch.h"
#include "brindle/distributed/rank_surface.h"
#include "brindle/distributed/selection.h"
#include "brindle/error.h"
#include "brindle/geometry/neighborhood.h"
#include "brindle/tensor_field.h"
#include "piece_slack.h"

namespace brindle::tool {
namespace {

/// "speed" of "points/speed".
std::string name_of_points(const std::string& name) {
  constexpr std::string_view kPoints = "points/";
  return name.starts_with(kPoints) ? name.substr(kPoints.size()) : name;
}

/// The piece as functions want it that take rows of arrays vertex by vertex.
Surface with_normals(const SurfacePiece& piece, std::span<const Vec3> normals, bool neighbors) {
  Surface surface{{piece.mesh.positions, {}}, nullptr, {normals.begin(), normals.end()}};
  if (neighbors) {
    surface.neighborhood = std::make_shared<const Adjacency>(vertex_neighborhood(piece.mesh));
  }
  return surface;
}

DirectionField array_directions(const DistributedSurface& surface, const ReadPiece& read,
                                const WaveOptions& options) {
  const std::string name = name_of_points(parse_array("--field", options.field));
  const DataArray& array = *find_array(read.arrays, name);
  if (is_tensor(array)) {
    return tensor_field_of(with_normals(read.piece, surface.normals(), true), array,
                           options.arrays.tensor.value_or(TensorAxis::major))
        .directions;
  }
  if (options.arrays.tensor) {
    throw Error("--tensor has no effect: the array '" + name + "' has " +
                std::to_string(array.components) + " numbers in a row, and is no tensor");
  }
  return direction_field_of(with_normals(read.piece, surface.normals(), false), array);
}

DirectionField make_directions(const DistributedSurface& surface, const ReadPiece& read,
                               const WaveOptions& options) {
  if (is_array(options.field)) {
    DirectionField directions;
    surface.rank_surface().ranks->together(
        [&] { directions = array_directions(surface, read, options); });
    return directions;
  }
  if (options.direction) return projected_direction_field(*options.direction, surface.normals());
  if (!is_smooth(options)) return curvature_direction_field(surface, options.curvature_direction);
  SmoothFieldOptions smooth;
  smooth.curvature_anchor = curvature_anchor(options);
  smooth.curvature_direction = options.curvature_direction;
  smooth.feature_anchor = options.feature_anchor;
  smooth.feature_angle_deg = options.feature_angle_deg;
  return smooth_direction_field(surface, smooth);
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
  const std::vector<float> edges(tally.edges_per_period.begin(), tally.edges_per_period.end());
  const std::size_t count = ranks.sum(edges.size());
  if (count == 0) return figures;
  figures.edges_per_period_min = static_cast<double>(kth_smallest(ranks, edges, 0));
  figures.edges_per_period_median = static_cast<double>(kth_smallest(ranks, edges, count / 2));
  return figures;
}

/// Takes waves from where an array says no frequency.
FrequencyField make_frequencies(const DistributedSurface& surface, const ReadPiece& read,
                                const WaveOptions& options, DirectionField& directions) {
  const std::string name = name_of_points(options.arrays.frequency);
  if (name.empty()) {
    return constant_frequency_field(
        constant_frequency(static_cast<float>(surface.diagonal()), options), directions.size());
  }
  FrequencyField frequencies;
  surface.rank_surface().ranks->together([&] {
    frequencies = frequencies_of(*find_array(read.arrays, name), directions);
    drop_waves_without_frequency(directions, frequencies);
  });
  return frequencies;
}

}  // namespace

std::vector<std::string> wanted_arrays(const WaveOptions& options) {
  std::vector<std::string> names;
  if (is_array(options.field)) {
    names.push_back(name_of_points(parse_array("--field", options.field)));
  }
  if (!options.arrays.frequency.empty()) {
    names.push_back(name_of_points(options.arrays.frequency));
  }
  return names;
}

PieceWaves make_piece_waves(Communicator& ranks, const DistributedSurface& surface,
                            const ReadPiece& read, const WaveOptions& options,
                            JobListener& listener) {
  Stopwatch watch;
  listener.stage("direction field");
  PieceWaves made;
  DirectionField directions = make_directions(surface, read, options);
  const float turn_deg = options.rotate_deg + (options.along ? 90.0f : 0.0f);
  if (turn_deg != 0) {
    directions = rotated(directions, surface.normals(), turn_deg * std::numbers::pi_v<float> / 180);
  }
  FrequencyField frequencies = make_frequencies(surface, read, options, directions);
  made.waves = {read.piece.mesh.positions, std::move(directions), std::move(frequencies)};
  made.figures = measure_waves(ranks, surface, made.waves);
  ranks.together([&] { check_waves(made.figures, source_of(options)); });
  listener.note(warnings(made.figures, source_of(options)));
  made.milliseconds = watch.lap();
  return made;
}

DistributedOptions animator_options(Communicator& ranks, const SolvingOptions& solving,
                                    const ReadPiece& read, const DistributedSurface& surface) {
  DistributedOptions options;
  options.solver = FrameSolver::multilevel;
  options.phase_shift = solving.stripes.phase_shift;
  options.weights = solving.stripes.weights;
  options.sweeps = solving.stripes.solver.sweeps;
  options.cycles = solving.stripes.solver.cycles;
  options.slack = piece_slack(ranks, solving.slack, read, surface.vertex_count());
  return options;
}

}  // namespace brindle::tool
