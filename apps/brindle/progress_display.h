/// Progress of a long job on stderr, and Ctrl-C.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "job_listener.h"

namespace brindle::tool {

/// Once a job has taken longer than a second, shows its stage: as one line that is rewritten where
/// stderr is a terminal, as one line a stage elsewhere. While it lives, Ctrl-C cancels the job at
/// its next report; a second Ctrl-C ends the program at once.
class ProgressDisplay : public JobListener {
 public:
  /// A quiet display shows nothing, but still cancels.
  explicit ProgressDisplay(bool quiet);
  ~ProgressDisplay() override;
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Cancels after Ctrl-C.
  Progress progress() override;

  /// Lines that stay, the same text only once; nothing if the display is quiet or the text empty.
  void note(const std::string& text) override;

 private:
  bool update(std::string_view stage, double fraction);
  void watch(const std::stop_token& stop);
  void show();
  void erase_line();

  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  const bool quiet_;
  const bool terminal_;
  void (*const previous_)(int);  // what Ctrl-C did before
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::set<std::string> noted_;
  std::string stage_;
  std::string shown_;
  double fraction_ = 0;
  std::jthread watcher_;  // last: stops before what it reads goes
};

}  // namespace brindle::tool
