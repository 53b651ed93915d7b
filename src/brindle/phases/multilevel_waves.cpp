#include "brindle/phases/multilevel_waves.h"

#include <vector>

#include "brindle/base/stopwatch.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/phases/solver_options.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

void couple_finest(const Adjacency& adjacency, const WaveSet& waves, PhaseShiftKind kind,
                   std::span<const float> edge_weights, const Progress& progress, Level& finest) {
  const SlicedLayout& layout = finest.layout();
  std::vector<SlicedWave> sliced;
  load_waves(layout, waves.positions, waves.directions, waves.frequencies, sliced);
  progress.report(0.3);
  std::vector<float> weights;
  if (!edge_weights.empty()) weights = sliced_weights(layout, adjacency, edge_weights);
  std::vector<float> degree(layout.slot_count());
  couple(layout, sliced, kind, weights, finest.couplings, degree);
}

}  // namespace

WaveSolution solve_multilevel_waves(const Adjacency& adjacency, const WaveSet& waves,
                                    PhaseShiftKind kind, std::span<const float> edge_weights,
                                    const SolverOptions& options, const Progress& progress) {
  check_solver_options(options);
  check_coupled_waves(adjacency, waves, edge_weights);
  JobStages stages(progress, multilevel_stages());
  const Progress coupling = stages.begin("couple");
  WaveSolution result;
  Hierarchy hierarchy = finest_level(adjacency, coupling.part(0, 0.8));
  coupling.report(0.8);
  Stopwatch watch;
  couple_finest(adjacency, waves, kind, edge_weights, coupling.part(0.8, 1), hierarchy.levels[0]);
  result.couple_milliseconds = watch.lap();
  coarsen(hierarchy, stages.begin("hierarchy"));
  watch.lap();
  const Level& finest = hierarchy.levels[0];
  const Index slots = finest.layout().slot_count();
  const SweepPlan plan = SweepPlan::for_new_levels(options.sweeps, slots);
  descend(hierarchy, plan, stages.begin("descent"));
  run_cycles(hierarchy, plan, options.cycles, stages.begin("cycles"));
  PhaseSolution& solution = result.solution;
  solution.z = to_nodes(finest.layout(), finest.z);
  solution.solve_milliseconds = hierarchy.numeric_milliseconds + watch.lap();
  solution.topology_milliseconds = hierarchy.topology_milliseconds;
  solution.iterations = plan.on_level(slots).count * (1 + options.cycles);
  solution.energy = energy(finest.layout(), finest.couplings, finest.z);
  stages.finish();
  return result;
}

}  // namespace brindle
