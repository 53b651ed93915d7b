/// Where inputs lie as files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace brindle::fuzz {

/// Writes a file into a folder in memory that goes with this process.
std::filesystem::path scratch_file(std::string_view name, std::span<const std::uint8_t> bytes);

/// A file there that need not exist.
std::filesystem::path scratch_path(std::string_view name);

}  // namespace brindle::fuzz
