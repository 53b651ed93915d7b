/// The files that a command reads and writes, which must not get into each other's way.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/surface_options.h"
#include "input/wave_options.h"

namespace brindle::tool {

struct UsedFile {
  std::string option;  ///< that names it
  std::filesystem::path path;
  bool beside = false;  ///< a picture beside a mesh, which meshes of one name share
};

/// The files of a mesh and of its field: none for shapes and fields that are made. Throws
/// CLI::ValidationError for a mesh without a name.
std::vector<UsedFile> input_files(const SurfaceOptions& surface, const WaveOptions& waves);

/// Those of the field alone.
std::vector<UsedFile> field_files(const WaveOptions& waves);

/// Throws CLI::ValidationError if an output is the same file as an input, which would be lost, or
/// as another output. Devices and pipes may be used as often as one likes.
void check_files(const std::vector<UsedFile>& inputs, const std::vector<UsedFile>& outputs);

/// Throws CLI::ValidationError unless the file ends in .json or is a device, Error if it could not
/// be written there. Without a path, nothing.
void check_report(const std::string& option, const std::string& path);

}  // namespace brindle::tool
