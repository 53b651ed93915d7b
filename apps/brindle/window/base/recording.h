/// A video of what the window shows.
#pragma once

#include <condition_variable>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>

#include "brindle/image.h"
#include "pictures/video_file.h"
#include "session/session_worker.h"

namespace brindle::tool {

/// Writes the newest picture thirty times a second, in a thread of its own, so that the video runs
/// as fast as what was seen. Unless `finish` has returned there is no file.
class Recording {
 public:
  /// The first picture's size is the video's. Throws what `VideoFile` throws.
  Recording(const std::filesystem::path& path, std::shared_ptr<const SessionFrame> first);
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// What is shown from now on. False if its size is not that of the video, which then goes on with
  /// the last picture.
  bool show(std::shared_ptr<const SessionFrame> frame);

  /// Whether it has failed: then `finish` throws why.
  bool failed() const;

  double seconds() const;
  const std::filesystem::path& path() const { return path_; }

  /// Waits until the file is written. Throws Error if that fails.
  void finish();

 private:
  void run(const std::stop_token& stop);

  std::filesystem::path path_;
  VideoFormat format_;
  VideoFile file_;
  mutable std::mutex mutex_;
  std::condition_variable_any ending_;
  std::shared_ptr<const SessionFrame> frame_;
  std::size_t written_ = 0;
  std::exception_ptr failure_;
  std::jthread thread_;  // last: ends before what it uses goes
};

}  // namespace brindle::tool
