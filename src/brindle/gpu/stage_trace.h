/// What each stage of a frame takes on the device: time, and bytes that are moved.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "brindle/gpu_animator.h"

namespace brindle {

class GpuTopology;

/// Timestamps between stages, taken on the device by OpenGL's timer queries.
class StageTimer {
 public:
  StageTimer() = default;
  ~StageTimer();
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

  /// Forgets the last stages; the first one begins here.
  void start();

  /// The stage that ends here; `name` must outlive the timer.
  void stage(std::string_view name);

  /// All stages since `start`, those of one name together, in the order of their first. Waits for
  /// the device.
  std::vector<StageTime> milliseconds() const;

 private:
  void mark();

  std::vector<unsigned> queries_;
  std::vector<std::string_view> names_;
};

/// Bytes read and written by the stages of a multilevel frame with anchors if every pass over a
/// level (a sweep is one) reads and writes each item once: gathers that miss the caches come on
/// top, levels that fit into them stay below.
std::vector<StageBytes> frame_traffic(const GpuTopology& topology);

}  // namespace brindle
