/// File names: extensions, and checks of names that other files mention.
#pragma once

#include <filesystem>
#include <string>

namespace brindle {

/// The path's extension with its dot, in lower case: ".ply" for "Scan.PLY".
std::string lower_extension(const std::filesystem::path& path);

/// Throws Error, with the remedy, if the file's name contains a line break or another control
/// character. Material libraries and comments of PLY mention names within a line.
void check_name_in_text(const std::filesystem::path& file);

/// The same for XML, which also requires UTF-8.
void check_name_in_xml(const std::filesystem::path& file);

}  // namespace brindle
