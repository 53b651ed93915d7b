/// Writes frames in the background.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace brindle::tool {

/// Runs jobs in order on its own thread. The destructor discards waiting jobs.
class FrameWriter {
 public:
  FrameWriter();
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// Blocks while `kMostWaiting` jobs wait. Throws the exception of an earlier job; later ones are
  /// not run.
  void add(std::function<void()> job);

  /// Waits for all jobs. Throws the exception of one that failed.
  void finish();

  /// Limited because frames are large.
  static constexpr std::size_t kMostWaiting = 3;

 private:
  void work();
  void rethrow() const;  // with the mutex locked

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> waiting_;
  bool busy_ = false;
  bool ending_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace brindle::tool
