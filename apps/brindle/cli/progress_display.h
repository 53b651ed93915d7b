/// Progress of a long job on stderr, and the signals that end it.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "cli/job_listener.h"

namespace brindle::tool {

/// Once a job has taken longer than a second, shows its stage: where stderr is a terminal as one
/// line that is rewritten, with what is done of the whole job; as one line a stage elsewhere. While
/// it lives, Ctrl-C, SIGTERM and SIGHUP cancel the job at its next report; a second one ends the
/// program at once.
class ProgressDisplay : public JobListener {
 public:
  /// A quiet display shows nothing, but still cancels.
  explicit ProgressDisplay(bool quiet);
  ~ProgressDisplay() override;
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Lines that stay, the same text only once; nothing if the display is quiet or the text empty.
  void note(const std::string& text) override;

 private:
  /// Cancels after such a signal.
  Progress whole_progress() override;
  bool update(const ProgressReport& report);
  void watch(const std::stop_token& stop);
  void show();
  void erase_line();

  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  const bool quiet_;
  const bool terminal_;
  std::array<void (*)(int), 3> previous_{};  // what the signals did before
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::set<std::string> noted_;
  std::string stage_;
  std::string shown_;
  double fraction_ = 0;
  std::jthread watcher_;  // last: stops before what it reads goes
};

/// What a program returns that was cancelled: 128 and the number of the signal that came, which is
/// 130 for Ctrl-C, 143 for SIGTERM and 129 for SIGHUP.
int cancelled_exit_code();

}  // namespace brindle::tool
