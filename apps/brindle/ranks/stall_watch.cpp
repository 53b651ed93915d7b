#include "ranks/stall_watch.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>

#include <mpi.h>

#include "brindle/base/text.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

std::atomic<const char*> stage_now{"beginning"};

/// Time for all waiting ranks to print their message.
constexpr std::chrono::seconds kMoment(2);

double seconds_of(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

[[noreturn]] void end_all(int rank, const Waiting& waiting, double limit) {
  const std::string message = formatted(
      "brindle: rank %d has waited %.0f s at '%s' %s (--stall-limit %g). Ranks that say "
      "nothing are waited for: have they stopped, or do they read what does not come? If they are "
      "only slow, take a longer limit, or 0 for none\n",
      rank, seconds_of(waiting.time), stage_now.load(), waiting.what, limit);
  std::fputs(message.c_str(), stderr);
  std::fflush(stderr);
  std::this_thread::sleep_for(kMoment);
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::_Exit(1);
}

}  // namespace

CLI::Option* add_stall_option(CLI::App& command, double& seconds) {
  return command
      .add_option("--stall-limit", seconds, "stop if a rank waits longer for the others; 0: never")
      ->envname("BRINDLE_STALL_LIMIT")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str();
}

void enter_stage(Communicator& ranks, JobListener& listener, const char* name) {
  stage_now = name;
  ranks.throw_on_all([&] { listener.stage(name); });
}

StallWatch::StallWatch(int rank, double seconds) : rank_(rank), seconds_(seconds) {
  if (seconds > 0) watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

StallWatch::~StallWatch() {
  if (!watcher_.joinable()) return;
  watcher_.request_stop();
  watcher_.join();
}

void StallWatch::watch(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  const std::chrono::duration<double> pause(std::clamp(seconds_ / 10, 0.01, 1.0));
  while (!stopped.wait_for(lock, stop, pause, [] { return false; }) && !stop.stop_requested()) {
    const auto waiting = waiting_now();
    if (waiting && seconds_of(waiting->time) > seconds_) end_all(rank_, *waiting, seconds_);
  }
}

}  // namespace brindle::tool
