#include "brindle/gpu_solver.h"

#include <string>

#include "brindle/base/stopwatch.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu/gpu_hierarchy.h"
#include "brindle/gpu/gpu_kernels.h"
#include "brindle/gpu/gpu_relaxation.h"
#include "brindle/phases/solver_options.h"

namespace brindle {
namespace {

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

}  // namespace

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
