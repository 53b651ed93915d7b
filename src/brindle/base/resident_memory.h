/// Resident memory of this process.
#pragma once

#include <cstddef>
#include <optional>

namespace brindle {

/// Bytes of the process's resident pages.
struct ResidentMemory {
  std::size_t now = 0;
  std::size_t peak = 0;  ///< since the start, or since reset_memory_peak
};

/// Empty on systems without /proc/self/status.
std::optional<ResidentMemory> resident_memory();

/// Returns freed pages to the system, so that new allocations count.
void return_free_memory();

/// Resets `peak` if the system can.
void reset_memory_peak();

}  // namespace brindle
