/// Conflicts between the files that a command reads and writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/surface_options.h"
#include "input/wave_options.h"

namespace brindle::tool {

struct UsedFile {
  std::string option;  ///< that gives it
  std::filesystem::path path;
  bool beside = false;  ///< an image beside a mesh; meshes of the same name share it
};

/// The files of a mesh and of its field, without built-in shapes and computed fields. Throws
/// CLI::ValidationError for a mesh without a name.
std::vector<UsedFile> input_files(const SurfaceOptions& surface, const WaveOptions& waves);

/// The files of the field alone.
std::vector<UsedFile> field_files(const WaveOptions& waves);

/// Throws CLI::ValidationError if an output is also an input, which would be lost, or another
/// output. Devices and pipes may be repeated.
void check_files(const std::vector<UsedFile>& inputs, const std::vector<UsedFile>& outputs);

/// Throws CLI::ValidationError unless the file ends in .json or is a device, Error if it cannot be
/// written. Ignores an empty path.
void check_report(const std::string& option, const std::string& path);

}  // namespace brindle::tool
