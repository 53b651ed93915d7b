/// Phase solvers on OpenGL's device.
#pragma once

#include <memory>

#include "brindle/export.h"
#include "brindle/solver.h"

namespace BRINDLE_EXPORT brindle {

/// The compute shaders of the solvers.
struct GpuKernels;

/// Compiles the shaders in the current OpenGL 4.5 context. This context, or one that shares its
/// objects, must be current whenever they are used or destroyed. One set serves all solvers of a
/// context. Throws Error, naming shader file and line, if the driver rejects one.
std::shared_ptr<const GpuKernels> make_gpu_kernels();

/// Whether the device supports the solver.
constexpr bool is_available_on_gpu(Solver solver) {
  return solver == Solver::multilevel || solver == Solver::relaxation;
}

/// Solves in the OpenGL 4.5 context that is current at construction. This context, or one that
/// shares its objects, must be current whenever the solver is used or destroyed.
class GpuSolver {
 public:
  /// Throws Error, naming shader file and line, if the driver rejects the shaders.
  GpuSolver();

  /// As `solve_phases` on the processor, which still makes colours, aggregates and lists; the
  /// device does all else. Throws Error for options out of range, for solvers other than multilevel
  /// and relaxation, and if the graph does not fit the device; Cancelled if `progress` cancels.
  PhaseSolution solve(const PhaseGraph& graph, const SolverOptions& options = {},
                      const Progress& progress = {}) const;

  std::shared_ptr<const GpuKernels> kernels() const { return kernels_; }

 private:
  std::shared_ptr<const GpuKernels> kernels_;
};

}  // namespace brindle
