/// Ranks that wait for each other too long.
#pragma once

#include <stop_token>
#include <thread>

#include <CLI/CLI.hpp>

#include "brindle/communicator.h"
#include "cli/job_listener.h"

namespace brindle::tool {

/// --stall-limit, and BRINDLE_STALL_LIMIT in the environment, which holds where the option is not
/// given.
void add_stall_option(CLI::App& command, double& seconds);

/// Seconds that a rank waits at most, unless it is told otherwise.
constexpr double kStallLimit = 900;

/// Collective. Where all ranks are from now on, for the display and for who watches.
void enter_stage(Communicator& ranks, JobListener& listener, const char* name);

/// While it lives, a thread looks whether this rank has waited for others longer than a limit.
/// Then it says where, waits a moment, as others may have something to say as well, and ends all
/// ranks with the exit code 1. A limit of 0: no end.
class StallWatch {
 public:
  StallWatch(int rank, double seconds);
  ~StallWatch();
  StallWatch(const StallWatch&) = delete;
  StallWatch& operator=(const StallWatch&) = delete;

 private:
  void watch(const std::stop_token& stop);

  const int rank_;
  const double seconds_;
  std::jthread watcher_;  // last: stops before what it reads goes
};

}  // namespace brindle::tool
