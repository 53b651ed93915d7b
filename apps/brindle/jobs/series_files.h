/// The files of a time series, by the one name that stands for them.
#pragma once

#include <string>
#include <vector>

#include "brindle/files.h"

namespace brindle::tool {

/// The steps of `name`, in order:
/// - a .pvd: its files, with its times;
/// - a name with %d or %04d: numbered files, from the first to the last, with numbers as times;
/// - a name with * or ?: all matching files, with numbers in numeric order and times 0, 1, 2 ...
/// Only the file name may be a pattern. Throws CLI::ValidationError with `option` for another kind
/// of name, Error if no file exists or a number is missing.
std::vector<TimedFile> series_files(const std::string& option, const std::string& name);

}  // namespace brindle::tool
