/// The energy and the step of phases, measured on the device.
#pragma once

#include <memory>
#include <optional>

#include "brindle/gpu/gpu_hierarchy.h"

namespace brindle {

struct PhaseMeasure {
  double energy = 0;      ///< as `energy()` of phase_graph.h defines it
  double weight = 0;      ///< sum of all weights
  double phase_step = 0;  ///< mean |angle| against the last phases, radians, over nodes with a wave
};

/// Reduces on the device. The result is read later, so that the frame that is measured does not
/// wait.
class GpuMeasure {
 public:
  /// For hierarchies with the topology of `hierarchy`.
  explicit GpuMeasure(const GpuHierarchy& hierarchy);
  ~GpuMeasure();
  GpuMeasure(GpuMeasure&&) noexcept;

  /// Begins to measure the finest level of `hierarchy` against `last_phases` (a buffer, by slot).
  /// At most two measurements may be under way.
  void begin(const GpuHierarchy& hierarchy, GLuint last_phases);

  /// The oldest measurement under way; waits for the device if that has not finished. Nothing if
  /// none is.
  std::optional<PhaseMeasure> end();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brindle
