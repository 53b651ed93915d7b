/// From a phase graph to phases on the device that OpenGL works on.
#pragma once

#include <memory>

#include "brindle/export.h"
#include "brindle/solver.h"

namespace BRINDLE_EXPORT brindle {

/// The compute shaders of the solvers.
struct GpuKernels;

/// Compiles them in the OpenGL 4.5 context that is current; that or one that shares its objects
/// must be current whenever they are used or destroyed. Once is enough for all that is solved in a
/// context. Throws Error, naming shader file and line, if the driver does not take one.
std::shared_ptr<const GpuKernels> make_gpu_kernels();

/// Whether the device has it, too.
constexpr bool is_available_on_gpu(Solver solver) {
  return solver == Solver::multilevel || solver == Solver::relaxation;
}

/// Solves in the OpenGL 4.5 context that is current when it is made. That one, or one that shares
/// its objects, must be current whenever it is used or destroyed.
class GpuSolver {
 public:
  /// Throws Error, naming shader file and line, if the driver does not take the shaders.
  GpuSolver();

  /// As `solve_phases` on the processor: colours, aggregates and lists are made there, all else is
  /// done on the device. Throws Error for options out of range, for other solvers than multilevel
  /// and relaxation, and if the graph does not fit the device; Cancelled if `progress` asks for it.
  PhaseSolution solve(const PhaseGraph& graph, const SolverOptions& options = {},
                      const Progress& progress = {}) const;

  std::shared_ptr<const GpuKernels> kernels() const { return kernels_; }

 private:
  std::shared_ptr<const GpuKernels> kernels_;
};

}  // namespace brindle
