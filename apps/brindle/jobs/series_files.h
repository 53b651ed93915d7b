/// The files of a time series, by the one name that stands for them.
#pragma once

#include <string>
#include <vector>

#include "brindle/time_series.h"

namespace brindle::tool {

/// The steps that `name` stands for, in their order:
/// - a .pvd: what it lists, with its times;
/// - a name with %d or %04d: files with numbers, from the first there is to the last, with the
///   numbers as times;
/// - a name with * or ?: all that match, numbers in them in numeric order, with times 0, 1, 2...
/// Only the last part of a path may have a pattern. Throws CLI::ValidationError, naming `option`,
/// for a name of another kind; Error if there is no such file, or one is missing between others.
std::vector<TimedFile> series_files(const std::string& option, const std::string& name);

}  // namespace brindle::tool
