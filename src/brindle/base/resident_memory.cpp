#include "brindle/base/resident_memory.h"

#include <fstream>
#include <sstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace brindle {
namespace {

constexpr std::size_t kKibibyte = 1024;

}  // namespace

std::optional<ResidentMemory> resident_memory() {
  std::ifstream status("/proc/self/status");
  std::optional<std::size_t> now, peak;
  for (std::string line; std::getline(status, line);) {
    std::istringstream fields(line);
    std::string name;
    std::size_t kibibytes = 0;
    if (!(fields >> name >> kibibytes)) continue;
    if (name == "VmRSS:") now = kibibytes * kKibibyte;
    if (name == "VmHWM:") peak = kibibytes * kKibibyte;
  }
  if (!now || !peak) return std::nullopt;
  return ResidentMemory{*now, *peak};
}

void return_free_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void reset_memory_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

}  // namespace brindle
