/// The paper's local optimization on the device (twin of phases/relaxation.h).
#pragma once

#include <memory>
#include <span>

#include "brindle/gpu/gpu_hierarchy.h"
#include "brindle/solver.h"

namespace brindle {

/// Iterations over the colours of the finest level of a hierarchy, with momenta.
class GpuRelaxation {
 public:
  /// For hierarchies with the topology of `hierarchy`; `strength` is s_m of Eq. 11.
  GpuRelaxation(const GpuHierarchy& hierarchy, float strength);

  /// Sets the momenta to zero.
  void clear() const;

  /// Continues from these phases by slot, with momenta transported from the last waves to these.
  /// All are buffer names.
  void follow(const GpuHierarchy& hierarchy, unsigned phases, unsigned last_waves,
              unsigned waves) const;

  /// One iteration over the first `colors` colours, with a dispatch each; does nothing after
  /// `judge` has found convergence.
  void iterate(const GpuHierarchy& hierarchy, std::size_t colors) const;

  /// The state of the iterations.
  struct Standing {
    std::uint32_t iterations = 0;
    std::uint32_t converged = 0;
    float weight = 0;  ///< sum of all weights
  };

  /// Starts counting iterations and recording energies, from `energy` (defined in phase_graph.h)
  /// and for at most `max_iterations`.
  void begin(double energy, double weight, int max_iterations);

  /// Records, on the device, the energy after an iteration over `colors` colours, and whether its
  /// relative improvement is below `epsilon`.
  void judge(const GpuHierarchy& hierarchy, std::size_t colors, float epsilon) const;

  /// The records since `begin`. Both functions wait for the device.
  Standing standing() const;
  std::vector<float> energies() const;  ///< before the first iteration and after each one

 private:
  float strength_;
  std::vector<std::uint32_t> first_part_;  ///< of every colour, and their number
  GlBuffer momenta_, parts_, commands_, relaxation_;
};

/// `relax` on the device.
PhaseSolution relax_on_gpu(std::shared_ptr<const GpuKernels> kernels, const PhaseGraph& graph,
                           const SolverOptions& options, std::span<const Complex> start = {},
                           const Progress& progress = {});

}  // namespace brindle
