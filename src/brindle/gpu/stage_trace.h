/// Device time and memory traffic of the stages of a frame.
#pragma once

#include <string_view>
#include <vector>

#include "brindle/gpu_animator.h"

namespace brindle {

class GpuTopology;

/// Timestamps between stages by OpenGL's timer queries.
class StageTimer {
 public:
  StageTimer() = default;
  ~StageTimer();
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

  /// Discards the last stages and starts the first one.
  void start();

  /// Ends a stage; `name` must outlive the timer.
  void stage(std::string_view name);

  /// The times since `start`, summed by name in order of first occurrence. Waits for the device.
  std::vector<StageTime> milliseconds() const;

 private:
  void mark();

  std::vector<unsigned> queries_;
  std::vector<std::string_view> names_;
};

/// Bytes read and written by the stages of a multilevel frame with anchors, if every pass over a
/// level, such as a sweep, reads and writes each item once. Cache misses of gathers add to this;
/// levels that fit into caches stay below.
std::vector<StageBytes> frame_traffic(const GpuTopology& topology);

}  // namespace brindle
