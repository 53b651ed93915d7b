/// Writing files without letting the window wait.
#pragma once

#include <functional>
#include <future>
#include <string>
#include <vector>

#include "window/live_session.h"

namespace brindle::tool {

/// Jobs on threads of their own. Each leaves a message in the session: what it wrote, or why not.
class BackgroundJobs {
 public:
  explicit BackgroundJobs(LiveSession& live) : live_(live) {}

  /// `job` gives the message for when it is done; what it throws is the message if it fails. It
  /// must not touch what the window's thread changes.
  /// `then` is called by `update` once it is done without failing.
  void start(std::function<std::string()> job, std::function<void()> then = {});

  /// Leaves the messages of those that have ended. Returns whether there were any.
  bool update();

  bool busy() const { return !running_.empty(); }

 private:
  struct Job {
    std::future<std::string> message;
    std::function<void()> then;
  };

  LiveSession& live_;
  std::vector<Job> running_;
};

}  // namespace brindle::tool
