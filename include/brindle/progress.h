/// Progress reports and cancellation of long jobs.
#pragma once

#include <functional>
#include <string_view>
#include <utility>

#include "brindle/error.h"
#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// Thrown out of a job whose progress callback asked it to stop.
class Cancelled : public Error {
 public:
  using Error::Error;
};

/// Handed into long jobs; a default-constructed one is silent and never cancels.
class Progress {
 public:
  /// Receives the stage's name and how much of it is done, in [0, 1]. Returning false cancels.
  using Callback = std::function<bool(std::string_view stage, double fraction)>;

  Progress() = default;
  explicit Progress(Callback callback) : callback_(std::move(callback)) {}

  /// Throws Cancelled if the callback asks for it.
  void report(std::string_view stage, double fraction) const {
    if (callback_ && !callback_(stage, fraction)) throw Cancelled("cancelled");
  }

 private:
  Callback callback_;
};

}  // namespace brindle
