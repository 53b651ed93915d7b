/// Writes frames while the next ones are made.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace brindle::tool {

/// Does one job after the other, in the order in which they were given, on a thread of its own.
/// Jobs still waiting when it is destroyed are left undone.
class FrameWriter {
 public:
  FrameWriter();
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// Waits while `kMostWaiting` jobs wait. Throws what an earlier job threw, after which no further
  /// one is done.
  void add(std::function<void()> job);

  /// Waits until all jobs are done. Throws what one of them threw.
  void finish();

  /// Frames are large.
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
