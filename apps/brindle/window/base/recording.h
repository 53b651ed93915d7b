/// Records the window's pictures as a video.
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

/// Writes the newest picture thirty times a second on its own thread, so that the video has the
/// speed of the window. Without `finish` there is no file.
class Recording {
 public:
  /// The video has the first picture's size. Throws what `VideoFile` throws.
  Recording(const std::filesystem::path& path, std::shared_ptr<const SessionFrame> first);
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// Sets the picture to write from now on. False if its size differs, and the last picture stays.
  bool show(std::shared_ptr<const SessionFrame> frame);

  /// Whether it failed; `finish` throws the reason.
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
  std::jthread thread_;  // declared last: ends before its members are destroyed
};

}  // namespace brindle::tool
