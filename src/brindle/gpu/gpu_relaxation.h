/// The paper's local optimisation on the device (twin: phases/relaxation.h).
#pragma once

#include <memory>
#include <span>

#include "brindle/gpu/gpu_hierarchy.h"
#include "brindle/solver.h"

namespace brindle {

/// Iterations over the colours of the finest level of a hierarchy, and what they carry from one to
/// the next.
class GpuRelaxation {
 public:
  /// For hierarchies with the topology of `hierarchy`; `strength` is s_m of Eq. 11.
  GpuRelaxation(const GpuHierarchy& hierarchy, float strength);

  /// Forgets the momenta.
  void clear() const;

  /// Lets iterations go on at these phases by slot, and momenta from the last waves to these ones.
  /// All are names of buffers.
  void follow(const GpuHierarchy& hierarchy, unsigned phases, unsigned last_waves,
              unsigned waves) const;

  /// One iteration over the first `colors` colours, a dispatch each; does nothing once `judge` has
  /// found convergence.
  void iterate(const GpuHierarchy& hierarchy, std::size_t colors) const;

  /// Where iterations stand.
  struct Standing {
    std::uint32_t iterations = 0;
    std::uint32_t converged = 0;
    float weight = 0;  ///< sum of all weights
  };

  /// Begins to count iterations and to note energies, from `energy` (as `energy()` of phase_graph.h
  /// defines it) and for so many iterations at most.
  void begin(double energy, double weight, int max_iterations);

  /// Notes the energy after an iteration over `colors` colours, and whether its relative
  /// improvement was below `epsilon`. The device does both, without waiting for the processor.
  void judge(const GpuHierarchy& hierarchy, std::size_t colors, float epsilon) const;

  /// The notes since `begin`. Both wait for the device.
  Standing standing() const;
  std::vector<float> energies() const;  ///< before the first iteration and after each one

 private:
  float strength_;
  std::vector<std::uint32_t> first_part_;  ///< of every colour, and their count
  GlBuffer momenta_, parts_, commands_, relaxation_;
};

/// `relax` on the device.
PhaseSolution relax_on_gpu(std::shared_ptr<const GpuKernels> kernels, const PhaseGraph& graph,
                           const SolverOptions& options, std::span<const Complex> start = {},
                           const Progress& progress = {});

}  // namespace brindle
