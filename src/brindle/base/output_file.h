/// Files that are either written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace brindle {

/// Lets `write` fill a temporary file beside `path`, then renames it to `path`. On any failure the
/// temporary file is removed and what stood at `path` before stays as it was. A `path` that is not
/// a regular file (a device, a pipe) is written to directly.
/// Throws Error, naming the path, the system's reason and the remedy, if the folder does not exist,
/// cannot be written to or is full; passes on what `write` throws.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// Throws the Error that `write_file` would throw for a `path` that is a folder, lies in a folder
/// that does not exist or may not be written to. Ask before a long job, whose result would be lost.
void check_output_path(const std::filesystem::path& path);

}  // namespace brindle
