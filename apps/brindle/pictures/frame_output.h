/// Frames of an animation, as files.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

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

/// Names of numbered files: folder / (before + number + after); the number is zero-padded to
/// `digits`.
struct FrameNames {
  std::filesystem::path folder;
  std::string before, after;
  int digits = 0;
};

/// Parses a pattern with one %d or %0Nd in the file name, %% for a percent sign; empty for other
/// names.
std::optional<FrameNames> parse_frame_names(const std::filesystem::path& pattern);

/// The file name without the folder.
std::string numbered_name(const FrameNames& names, long number);

/// A video file, one picture per frame, or one mesh per step of a series.
struct FrameOutput {
  std::filesystem::path video;  ///< empty for pictures and meshes
  FrameNames names;             ///< of pictures and meshes
  bool meshes = false;

  bool is_video() const { return !video.empty(); }
};

/// Parses "name.mp4", or a pattern of PNG or VTP files. Throws CLI::ValidationError with `option`
/// for anything else.
FrameOutput parse_frame_output(const std::string& option, const std::string& text);

/// The file of picture or mesh `number`.
std::filesystem::path frame_path(const FrameOutput& output, std::size_t number);

/// The file beside the meshes that lists them with their times.
std::filesystem::path collection_path(const FrameOutput& output);

/// All files of an animation, including the collection of meshes.
std::vector<std::filesystem::path> frame_files(const FrameOutput& output, std::size_t count);

/// Throws Error if the folder does not exist or is not writable, and for a video without the ffmpeg
/// program.
void check_frame_output(const FrameOutput& output);

}  // namespace brindle::tool
