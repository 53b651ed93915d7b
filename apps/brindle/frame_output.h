/// Where the frames of an animation go.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace brindle::tool {

/// A video file, or one picture a frame.
struct FrameOutput {
  std::filesystem::path video;  ///< empty for pictures

  // picture n is folder / (before + n + after), n filled up with zeros to `digits`
  std::filesystem::path folder;
  std::string before, after;
  int digits = 0;

  bool is_video() const { return !video.empty(); }
};

/// Reads "name.mp4" or a pattern with one %d or %0Nd in the name of a PNG file, %% standing for a
/// percent sign. Throws CLI::ValidationError for anything else, naming `option`.
FrameOutput parse_frame_output(const std::string& option, const std::string& text);

/// The file of picture `number`.
std::filesystem::path picture_path(const FrameOutput& output, int number);

/// The video, or all pictures of an animation.
std::vector<std::filesystem::path> frame_files(const FrameOutput& output, int frames);

/// Throws Error if the folder does not exist or cannot be written to, or the output is a video and
/// the ffmpeg program is not to be found.
void check_frame_output(const FrameOutput& output);

}  // namespace brindle::tool
