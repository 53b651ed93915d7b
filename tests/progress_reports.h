/// Progress that counts its reports and cancels at one of them, for the tests of several rooms.
#pragma once

#include <vector>

#include "brindle/progress.h"

namespace brindle::testing_support {

class Reports {
 public:
  /// Cancels at the report of this number, from 0; never if negative.
  explicit Reports(int cancelled = -1) : cancelled_(cancelled) {}
  Reports(const Reports&) = delete;
  Reports& operator=(const Reports&) = delete;

  Progress progress() {
    return Progress([this](std::string_view, double) { return count_++ != cancelled_; });
  }
  int count() const { return count_; }

 private:
  int cancelled_;
  int count_ = 0;
};

/// Numbers of reports to cancel at: all of few, and of many a share with the first and the last.
inline std::vector<int> reports_to_cancel(int count, int most = 12) {
  const int tried = count < most ? count : most;
  std::vector<int> numbers;
  for (int k = 0; k < tried; ++k) {
    numbers.push_back(
        tried == 1 ? 0 : static_cast<int>(static_cast<long>(k) * (count - 1) / (tried - 1)));
  }
  return numbers;
}

}  // namespace brindle::testing_support
