/// Measures the energy and the change of phases on the device.
#pragma once

#include <memory>
#include <optional>

#include "brindle/gpu/gpu_hierarchy.h"

namespace brindle {

struct PhaseMeasure {
  double energy = 0;      ///< as `energy()` of phase_graph.h defines it
  double weight = 0;      ///< sum of all weights
  double phase_step = 0;  ///< mean |angle| to the last phases, radians, over nodes with a wave
};

/// Reduces on the device. The result is read later, so that the frame does not wait.
class GpuMeasure {
 public:
  /// For hierarchies with the topology of `hierarchy`.
  explicit GpuMeasure(const GpuHierarchy& hierarchy);
  ~GpuMeasure();
  GpuMeasure(GpuMeasure&&) noexcept;

  /// Starts measuring the finest level of `hierarchy` against `last_phases` (a buffer, by slot). At
  /// most two measurements may be pending.
  void begin(const GpuHierarchy& hierarchy, GLuint last_phases);

  /// The oldest pending measurement, waiting for the device if necessary; empty if none is pending.
  std::optional<PhaseMeasure> end();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brindle
