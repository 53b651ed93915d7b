/// Writing files without letting the window wait.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "cli/job_listener.h"
#include "window/base/live_session.h"

namespace brindle::tool {

/// Jobs on threads of their own. Each leaves a message in the session: what it wrote, or why not.
class BackgroundJobs {
 public:
  explicit BackgroundJobs(LiveSession& live) : live_(live) {}
  /// Waits for them: what was asked for is written.
  ~BackgroundJobs() = default;

  /// `job` gives the message for when it is done; what it throws is the message if it fails. It
  /// must not touch what the window's thread changes.
  /// `then` is called by `update` once it is done without failing.
  void start(std::function<std::string()> job, std::function<void()> then = {});

  /// The same of what writes one file: it says how far it is, and may be cancelled. The message has
  /// its notes.
  void write(const std::filesystem::path& path, std::function<void(JobListener&)> job);

  /// Leaves the messages of those that have ended. Returns whether there were any.
  bool update();

  bool busy() const { return !running_.empty(); }

  /// A file that is being written.
  struct Writing {
    std::filesystem::path path;
    std::string step;
    double fraction;
    std::function<void()> cancel;
  };
  std::vector<Writing> being_written() const;

 private:
  class Listener;

  struct Job {
    std::future<std::string> message;
    std::function<void()> then;
    std::filesystem::path path;          ///< that `write` was called for
    std::shared_ptr<Listener> listener;  ///< null of those of `start`
  };

  LiveSession& live_;
  std::vector<Job> running_;
};

}  // namespace brindle::tool
