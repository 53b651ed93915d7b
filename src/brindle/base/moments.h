/// Mean and deviation of numbers that are summed in parts.
#pragma once

#include <algorithm>
#include <cmath>

namespace brindle {

/// Sums of powers. `parallel_sum` adds the parts in a fixed order.
struct Moments {
  double count = 0, sum = 0, square_sum = 0;

  void add(double x) {
    count += 1;
    sum += x;
    square_sum += x * x;
  }
  Moments operator+(const Moments& other) const {
    return {count + other.count, sum + other.sum, square_sum + other.square_sum};
  }

  /// Of no numbers, not a number.
  double mean() const { return sum / count; }
  double deviation() const {
    return std::sqrt(std::max(0.0, square_sum / count - mean() * mean()));
  }
};

}  // namespace brindle
