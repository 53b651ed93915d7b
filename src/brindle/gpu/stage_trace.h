/// Device time of the stages of a frame.
#pragma once

#include <string_view>
#include <vector>

#include "brindle/gpu_animator.h"

namespace brindle {

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

}  // namespace brindle
