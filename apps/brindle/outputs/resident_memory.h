/// How much memory this process has in use.
#pragma once

#include <cstddef>
#include <optional>

namespace brindle::tool {

/// Bytes of memory pages that the process holds.
struct ResidentMemory {
  std::size_t now = 0;
  std::size_t peak = 0;  ///< since the start, or since reset_memory_peak
};

/// Nothing on systems that do not tell (they have no /proc/self/status).
std::optional<ResidentMemory> resident_memory();

/// Gives pages that were freed back to the system, so that what is allocated next counts.
void return_free_memory();

/// Lets `peak` begin anew where the system can.
void reset_memory_peak();

}  // namespace brindle::tool
