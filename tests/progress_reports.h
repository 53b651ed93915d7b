/// Progress that counts its reports and cancels at one of them, for the tests of several rooms.
#pragma once

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

}  // namespace brindle::testing_support
