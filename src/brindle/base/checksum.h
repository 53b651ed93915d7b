/// Checksums of file formats.
#pragma once

#include <cstdint>
#include <string_view>

namespace brindle {

/// CRC-32 of PNG and ZIP files.
std::uint32_t crc32_of(std::string_view bytes);

}  // namespace brindle
