/// Files that are opened for reading.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace brindle {

/// Opens a regular file, as bytes. Devices and pipes are refused: they have no size, and some never
/// end. Throws Error, naming the file and the remedy, for these, for a folder, and for what is not
/// there or may not be read. `kind` is what the file should be: "a mesh file".
std::ifstream open_input(const std::filesystem::path& path, const std::string& kind);

/// All that is in the file. Throws Error as `open_input` does, and where reading fails.
std::string whole_input(const std::filesystem::path& path, const std::string& kind);

}  // namespace brindle
