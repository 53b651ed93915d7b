#include "brindle/gpu_solver.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu/gpu_hierarchy.h"
#include "brindle/gpu/gpu_kernels.h"
#include "brindle/gpu/gpu_measure.h"
#include "brindle/gpu/gpu_relaxation.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/relaxation.h"

namespace brindle {
namespace {

/// Iterations between two convergence checks, which wait for the device.
constexpr int kIterationBatch = 8;

PhaseSolution solve_multilevel(std::shared_ptr<const GpuKernels> kernels, const PhaseGraph& graph,
                               const SolverOptions& options, const Progress& progress) {
  PhaseSolution solution;
  Stopwatch watch;
  JobStages stages(progress, {{"hierarchy", 5}, {"cycles", 1}});
  const Hierarchy hierarchy = build_hierarchy(graph, stages.begin("hierarchy"));
  const Level& finest = hierarchy.levels[0];
  const Index slots = finest.layout().slot_count();
  const SweepPlan plan = SweepPlan::for_new_levels(options.sweeps, slots);
  GpuHierarchy device(std::move(kernels), topology_of(hierarchy, plan));
  device.upload(finest.layout(), finest.couplings);
  glFinish();
  solution.topology_milliseconds = watch.lap();
  device.solve();
  device.run_cycles(options.cycles, stages.begin("cycles"));
  solution.z = to_nodes(finest.layout(), device.read_phases());
  check_gl("solving on the GPU");
  solution.solve_milliseconds = watch.lap();
  solution.iterations = plan.on_level(slots).count * (1 + options.cycles);
  solution.energy = energy(graph, solution.z);
  stages.finish();
  return solution;
}

/// Iterates until convergence, with a check every few iterations.
void relax_to_convergence(const GpuHierarchy& hierarchy, const GpuRelaxation& relaxation,
                          const SolverOptions& options, const Progress& progress) {
  const std::size_t all = hierarchy.topology().colors(0).size();
  const std::size_t first_two_thirds = all - all / 3;
  GpuRelaxation::Standing standing;
  const auto limit = static_cast<std::uint32_t>(options.max_iterations);
  while (!standing.converged && standing.iterations < limit) {
    const std::uint32_t end = std::min<std::uint32_t>(standing.iterations + kIterationBatch, limit);
    for (std::uint32_t i = standing.iterations; i < end; ++i) {
      const bool skip = options.skip_last_third && i % 2 == 1;
      relaxation.iterate(hierarchy, skip ? first_two_thirds : all);
      relaxation.judge(hierarchy, skip ? first_two_thirds : all, options.epsilon);
    }
    standing = relaxation.standing();
    progress.report("relaxation", 1 - std::min(1.0f, relaxation.energies().back() / 0.5f));
  }
}

}  // namespace

PhaseSolution relax_on_gpu(std::shared_ptr<const GpuKernels> kernels, const PhaseGraph& graph,
                           const SolverOptions& options, std::span<const Complex> start,
                           const Progress& progress) {
  PhaseSolution solution;
  Stopwatch watch;
  const auto layout =
      std::make_shared<const SlicedLayout>(relaxation_layout(*graph.adjacency, options.seed));
  const std::array<LevelTopology, 1> levels{{{layout, nullptr}}};
  GpuHierarchy hierarchy(std::move(kernels),
                         std::make_shared<const GpuTopology>(flatten(levels, options.sweeps)));
  SlicedCouplings couplings(*layout);
  load_couplings(graph, *layout, couplings);
  hierarchy.upload(*layout, couplings);
  hierarchy.upload_phases(start_phases(*layout, start, options.seed));
  glFinish();
  solution.topology_milliseconds = watch.lap();

  GpuMeasure measure(hierarchy);
  measure.begin(hierarchy, hierarchy.phases());
  const PhaseMeasure before = *measure.end();
  GpuRelaxation relaxation(hierarchy, options.momentum);
  relaxation.begin(before.energy, before.weight, options.max_iterations);
  if (before.weight > 0) relax_to_convergence(hierarchy, relaxation, options, progress);
  solution.z = to_nodes(*layout, hierarchy.read_phases());
  const std::vector<float> energies = relaxation.energies();
  check_gl("relaxing on the GPU");
  solution.solve_milliseconds = watch.lap();
  solution.energy_per_iteration.assign(energies.begin(), energies.end());
  solution.iterations = static_cast<int>(energies.size()) - 1;
  solution.energy = energy(graph, solution.z);
  return solution;
}

GpuSolver::GpuSolver() : kernels_(std::make_shared<const GpuKernels>()) {}

PhaseSolution GpuSolver::solve(const PhaseGraph& graph, const SolverOptions& options,
                               const Progress& progress) const {
  check_solver_options(options);
  if (!is_available_on_gpu(options.solver)) {
    throw Error("the GPU has no solver '" + std::string(name_of(options.solver)) +
                "'; take multilevel or relaxation, or solve on the processor");
  }
  if (options.solver == Solver::relaxation) {
    if (options.cycles > 0) {
      throw Error("the GPU has cycles for multilevel alone; solve on the processor");
    }
    return relax_on_gpu(kernels_, graph, options, {}, progress);
  }
  return solve_multilevel(kernels_, graph, options, progress);
}

}  // namespace brindle
