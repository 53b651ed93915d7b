#include "progress_display.h"

#include <csignal>
#include <cstdio>
#include <sstream>

#include <unistd.h>

namespace brindle::tool {
namespace {

using namespace std::chrono_literals;

volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

ProgressDisplay::ProgressDisplay(bool quiet)
    : quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      previous_(std::signal(SIGINT, on_interrupt)) {
  if (previous_ == SIG_IGN) std::signal(SIGINT, SIG_IGN);  // started in the background
  if (!quiet) watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

ProgressDisplay::~ProgressDisplay() {
  if (watcher_.joinable()) {
    watcher_.request_stop();
    watcher_.join();
  }
  erase_line();
  std::signal(SIGINT, previous_);
}

Progress ProgressDisplay::progress() {
  return Progress(
      [this](std::string_view stage, double fraction) { return update(stage, fraction); });
}

void ProgressDisplay::note(const std::string& text) {
  if (quiet_ || text.empty()) return;
  const std::lock_guard lock(mutex_);
  if (!noted_.insert(text).second) return;
  erase_line();
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::fprintf(stderr, "brindle: %s\n", line.c_str());
  }
}

bool ProgressDisplay::update(std::string_view stage, double fraction) {
  const std::lock_guard lock(mutex_);
  stage_ = stage;
  fraction_ = fraction;
  return interrupted == 0;
}

// A thread of its own, because a stage may not report for seconds.
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
    std::fprintf(stderr, "\r\x1b[K%s", line.c_str());
  } else {
    std::fprintf(stderr, "brindle: %s\n", line.c_str());
  }
  std::fflush(stderr);
  shown_ = line;
}

}  // namespace brindle::tool
