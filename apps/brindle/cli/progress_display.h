/// Progress of a long job on stderr, and signals that end it.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include <CLI/CLI.hpp>

#include "cli/job_listener.h"

namespace brindle::tool {

/// Shows the stage of a job that takes longer than a second: on terminals as one line with the
/// progress of the whole job, elsewhere as one line per stage. During its lifetime, Ctrl-C, SIGTERM
/// and SIGHUP cancel the job at its next report; a second signal ends the program at once.
class ProgressDisplay : public JobListener {
 public:
  /// A quiet display prints nothing, but still cancels. Notes name options as `command` does.
  explicit ProgressDisplay(bool quiet, const CLI::App* command = nullptr);
  ~ProgressDisplay() override;
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Permanent lines, without repetitions; none if the display is quiet or the text empty.
  void note(const std::string& text) override;

 private:
  /// Throws Cancelled after a signal.
  Progress whole_progress() override;
  bool update(const ProgressReport& report);
  void watch(const std::stop_token& stop);
  void show();
  void erase_line();

  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  const bool quiet_;
  const bool terminal_;
  const CLI::App* command_;
  std::array<void (*)(int), 3> previous_{};  // previous signal handlers
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::set<std::string> noted_;
  std::string stage_;
  std::string shown_;
  double fraction_ = 0;
  std::jthread watcher_;  // declared last: stops before its members are destroyed
};

/// The exit code of a cancelled program: 128 plus the signal number, which is 130 for Ctrl-C, 143
/// for SIGTERM and 129 for SIGHUP.
int cancelled_exit_code();

}  // namespace brindle::tool
