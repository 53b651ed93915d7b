/// Where the frames of an animation go.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace brindle::tool {

/// Names of files with a number in them: folder / (before + number + after), the number filled up
/// with zeros to `digits`.
struct FrameNames {
  std::filesystem::path folder;
  std::string before, after;
  int digits = 0;
};

/// Reads a pattern with one %d or %0Nd in the file's name, %% standing for a percent sign; nothing
/// if it is none.
std::optional<FrameNames> parse_frame_names(const std::filesystem::path& pattern);

/// The name without the folder.
std::string numbered_name(const FrameNames& names, long number);

/// A video file, one picture per frame, or one mesh per step of a series.
struct FrameOutput {
  std::filesystem::path video;  ///< empty for pictures and meshes
  FrameNames names;             ///< of pictures and meshes
  bool meshes = false;

  bool is_video() const { return !video.empty(); }
};

/// Reads "name.mp4", or a pattern for PNG or VTP files. Throws CLI::ValidationError for anything
/// else, naming `option`.
FrameOutput parse_frame_output(const std::string& option, const std::string& text);

/// The file of picture or mesh `number`.
std::filesystem::path frame_path(const FrameOutput& output, std::size_t number);

/// The file beside meshes that lists them with their times.
std::filesystem::path collection_path(const FrameOutput& output);

/// The video, or all pictures or meshes of an animation, of meshes also the collection.
std::vector<std::filesystem::path> frame_files(const FrameOutput& output, std::size_t count);

/// Throws Error if the folder does not exist or cannot be written to, or the output is a video and
/// the ffmpeg program is not to be found.
void check_frame_output(const FrameOutput& output);

}  // namespace brindle::tool
