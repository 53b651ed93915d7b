/// Writes files in the background.
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

/// Jobs on threads of their own. Each adds a message to the session: what was written, or the
/// error.
class BackgroundJobs {
 public:
  explicit BackgroundJobs(LiveSession& live) : live_(live) {}
  /// Waits for all jobs.
  ~BackgroundJobs() = default;

  /// Starts `job`, which returns the final message or throws the error message. It must not touch
  /// data that the window's thread changes. `update` calls `then` after success.
  void start(std::function<std::string()> job, std::function<void()> then = {});

  /// The same for one file, with progress and cancellation. The message includes its notes.
  void write(const std::filesystem::path& path, std::function<void(JobListener&)> job);

  /// Adds the messages of completed jobs. Returns whether there were any.
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
    std::filesystem::path path;          ///< passed to `write`
    std::shared_ptr<Listener> listener;  ///< null for jobs of `start`
  };

  LiveSession& live_;
  std::vector<Job> running_;
};

}  // namespace brindle::tool
