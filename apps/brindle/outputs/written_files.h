/// Prints which files were written.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>

namespace brindle::tool {

/// A line `wrote FILE (size)`.
void print_written(std::ostream& out, const std::filesystem::path& file);

/// The same for many files of one kind, as one line.
void print_written(std::ostream& out, std::span<const std::filesystem::path> files);

}  // namespace brindle::tool
