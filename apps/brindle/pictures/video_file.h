/// Video files, written by the ffmpeg program.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>

#include <sys/types.h>

#include "brindle/base/output_file.h"

namespace brindle::tool {

/// Throws Error with the package to install and an alternative if the ffmpeg program is not on the
/// PATH.
void check_video_available(const std::filesystem::path& path);

struct VideoFormat {
  int width = 0;   ///< pixels; H.264 needs even sizes, so an odd last column or row is dropped
  int height = 0;  ///< pixels
  int frames_per_second = 30;
};

/// An MP4 file, written frame by frame under a temporary name. Unless `finish` has returned, the
/// destructor stops the program and removes the file.
class VideoFile {
 public:
  /// Throws Error if the program cannot be started, and as `write_file` does.
  VideoFile(std::filesystem::path path, const VideoFormat& format);
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// Adds a frame of width * height pixels of 4 bytes: red, green, blue, unused. Throws Error with
  /// the program's own message if it has ended.
  void add(std::span<const std::byte> pixels);

  /// Waits for the program and gives the file its name. Throws Error if either fails.
  void finish();

 private:
  [[noreturn]] void fail(const std::string& reason);
  int close_and_wait();

  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, CloseFile>;

  std::filesystem::path path_;
  UnfinishedFile file_;
  File messages_;  // output of the program
  File frames_;    // pipe to the program
  pid_t program_ = -1;
};

}  // namespace brindle::tool
