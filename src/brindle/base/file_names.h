/// Names of files: extensions, and names that other files can mention.
#pragma once

#include <filesystem>
#include <string>

namespace brindle {

/// The path's extension with its dot, in small letters: ".ply" for "Scan.PLY".
std::string lower_extension(const std::filesystem::path& path);

/// Throws Error, with the remedy, if the file's name cannot stand in a line of text, as material
/// libraries and comments of PLY have it: it has a line break or another control character.
void check_name_in_text(const std::filesystem::path& file);

/// The same for XML, which has no letters but those of UTF-8.
void check_name_in_xml(const std::filesystem::path& file);

}  // namespace brindle
