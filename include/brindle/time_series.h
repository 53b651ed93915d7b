/// Time series of files in ParaView's formats .pvd and .series.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// A file of a time series.
struct TimedFile {
  double time = 0;
  std::filesystem::path file;
};

/// The files that a .pvd lists, in the order of their times, with paths relative to its folder
/// resolved. Throws Error, naming the file and the remedy, if it cannot be read, is no collection,
/// lists nothing, or more than one file for a time.
std::vector<TimedFile> read_pvd(const std::filesystem::path& path);

/// As above for a .series, a JSON file: {"files": [{"name": "a.vtu", "time": 0.5}, ...]}.
std::vector<TimedFile> read_file_series(const std::filesystem::path& path);

/// Writes a .pvd, whole or not at all, with paths relative to its folder. Throws Error for names
/// that XML cannot hold, and what write_file throws.
void write_pvd(const std::filesystem::path& path, std::span<const TimedFile> files);

}  // namespace brindle
