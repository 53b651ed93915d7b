/// Outputs of an animation's frames.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace brindle::tool {

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
