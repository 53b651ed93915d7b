#include "brindle/phases/multilevel_waves.h"

#include <string>
#include <vector>

#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

void check_input(const Adjacency& adjacency, const WaveSet& waves,
                 std::span<const float> edge_weights) {
  const std::size_t nodes = adjacency.node_count();
  if (waves.positions.size() != nodes || waves.directions.size() != nodes ||
      waves.frequencies.size() != nodes) {
    throw Error("waves: there must be one position, direction and frequency for each of " +
                std::to_string(nodes) + " vertices");
  }
  check_waves(waves.positions, waves.directions, waves.frequencies);
  if (!edge_weights.empty() && edge_weights.size() != adjacency.directed_edge_count()) {
    throw Error("waves: there must be one edge weight per directed edge");
  }
  check_edge_weights(edge_weights);
}

void couple_finest(const Adjacency& adjacency, const WaveSet& waves, PhaseShiftKind kind,
                   std::span<const float> edge_weights, Level& finest) {
  const SlicedLayout& layout = finest.layout();
  std::vector<SlicedWave> sliced;
  load_waves(layout, waves.positions, waves.directions, waves.frequencies, sliced);
  std::vector<float> weights;
  if (!edge_weights.empty()) weights = sliced_weights(layout, adjacency, edge_weights);
  std::vector<float> degree(layout.slot_count());
  couple(layout, sliced, kind, weights, finest.couplings, degree);
}

}  // namespace

WaveSolution solve_multilevel_waves(const Adjacency& adjacency, const WaveSet& waves,
                                    PhaseShiftKind kind, std::span<const float> edge_weights,
                                    const SolverOptions& options, const Progress& progress) {
  check(options);
  check_input(adjacency, waves, edge_weights);
  WaveSolution result;
  Hierarchy hierarchy = finest_level(adjacency);
  Stopwatch watch;
  couple_finest(adjacency, waves, kind, edge_weights, hierarchy.levels[0]);
  result.couple_milliseconds = watch.lap();
  coarsen(hierarchy, progress);
  watch.lap();
  const Level& finest = hierarchy.levels[0];
  descend(hierarchy, options.sweeps);
  run_cycles(hierarchy, options.sweeps, options.cycles, progress);
  PhaseSolution& solution = result.solution;
  solution.z = to_nodes(finest.layout(), finest.z);
  solution.solve_milliseconds = hierarchy.numeric_milliseconds + watch.lap();
  solution.topology_milliseconds = hierarchy.topology_milliseconds;
  solution.iterations = options.sweeps * (1 + options.cycles);
  solution.energy = energy(finest.layout(), finest.couplings, finest.z);
  return result;
}

}  // namespace brindle
