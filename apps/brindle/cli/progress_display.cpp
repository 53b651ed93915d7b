#include "cli/progress_display.h"

#include <csignal>
#include <cstdio>
#include <sstream>

#include <unistd.h>

#include "brindle/base/text.h"
#include "cli/option_parts.h"

namespace brindle::tool {
namespace {

using namespace std::chrono_literals;

/// Ctrl-C, `kill` and shutdown, and a closed terminal.
constexpr std::array<int, 3> kEnding = {SIGINT, SIGTERM, SIGHUP};

/// The first signal that arrived, or 0.
volatile std::sig_atomic_t ended_by = 0;

void on_ending(int signal) {
  if (ended_by == 0) ended_by = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

int cancelled_exit_code() { return 128 + (ended_by == 0 ? SIGINT : ended_by); }

ProgressDisplay::ProgressDisplay(bool quiet, const CLI::App* command)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), command_(command) {
  for (std::size_t i = 0; i < kEnding.size(); ++i) {
    previous_[i] = std::signal(kEnding[i], on_ending);
    // Ignored by the parent, as by nohup or in the background.
    if (previous_[i] == SIG_IGN) std::signal(kEnding[i], SIG_IGN);
  }
  if (!quiet) watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

ProgressDisplay::~ProgressDisplay() {
  if (watcher_.joinable()) {
    watcher_.request_stop();
    watcher_.join();
  }
  erase_line();
  for (std::size_t i = 0; i < kEnding.size(); ++i) std::signal(kEnding[i], previous_[i]);
}

Progress ProgressDisplay::whole_progress() {
  return Progress([this](const ProgressReport& report) { return update(report); });
}

void ProgressDisplay::note(const std::string& text) {
  if (quiet_ || text.empty()) return;
  const std::lock_guard lock(mutex_);
  if (!noted_.insert(text).second) return;
  erase_line();
  std::istringstream lines(command_ == nullptr ? text : in_command_words(*command_, text));
  for (std::string line; std::getline(lines, line);) {
    std::fprintf(stderr, "brindle: %s\n", shown_lines(line).c_str());
  }
}

bool ProgressDisplay::update(const ProgressReport& report) {
  const std::lock_guard lock(mutex_);
  stage_ = terminal_ || report.stages.empty() ? report.step
                                              : std::string_view(report.stages[report.stage].name);
  fraction_ = report.stages.empty() ? report.step_fraction : report.fraction;
  return ended_by == 0;
}

// On its own thread, because a stage may not report for seconds.
void ProgressDisplay::watch(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, stop, 100ms, [] { return false; }) && !stop.stop_requested()) {
    if (std::chrono::steady_clock::now() - start_ > 1s) show();
  }
}

void ProgressDisplay::erase_line() {
  if (terminal_ && !shown_.empty()) std::fputs("\r\x1b[K", stderr);
  shown_.clear();
}

void ProgressDisplay::show() {
  std::string line = stage_;
  if (terminal_ && fraction_ > 0) {
    line += ' ' + std::to_string(static_cast<int>(100 * fraction_)) + " %";
  }
  if (line == shown_) return;
  if (terminal_) {
    std::fprintf(stderr, "\r\x1b[K%s", shown_lines(line).c_str());
  } else {
    std::fprintf(stderr, "brindle: %s\n", shown_lines(line).c_str());
  }
  std::fflush(stderr);
  shown_ = line;
}

}  // namespace brindle::tool
