/// Detects ranks that wait for each other too long.
#pragma once

#include <stop_token>
#include <thread>

#include <CLI/CLI.hpp>

#include "brindle/communicator.h"
#include "cli/job_listener.h"

namespace brindle::tool {

/// --stall-limit, with BRINDLE_STALL_LIMIT in the environment as its default.
CLI::Option* add_stall_option(CLI::App& command, double& seconds);

/// The default limit of waiting, in seconds.
constexpr double kStallLimit = 900;

/// Collective. Names the stage of all ranks, for the display and the watch.
void enter_stage(Communicator& ranks, JobListener& listener, const char* name);

/// RAII: a thread checks whether this rank has waited for others longer than the limit. If so, it
/// prints where, lets other ranks do the same, and ends all ranks with exit code 1. 0: no limit.
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
  std::jthread watcher_;  // declared last: stops before its members are destroyed
};

}  // namespace brindle::tool
