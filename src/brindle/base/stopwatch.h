/// Wall-clock time of a stage.
#pragma once

#include <chrono>

namespace brindle {

/// Runs from its construction, or from the last lap.
class Stopwatch {
 public:
  /// Milliseconds since construction or since the last lap; starts the next lap.
  double lap() {
    const auto now = Clock::now();
    const std::chrono::duration<double, std::milli> elapsed = now - start_;
    start_ = now;
    return elapsed.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace brindle
