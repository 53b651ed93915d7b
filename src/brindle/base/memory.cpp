#include "brindle/base/memory.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>

#if defined(__EMSCRIPTEN__)
#include <emscripten/heap.h>
#include <malloc.h>
#elif defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <unistd.h>
#define BRINDLE_HAS_LIMITS
#endif

namespace brindle {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

std::atomic<double> assumed{-1};  // below 0: nothing is assumed

/// The number that a file begins with, as control groups have them.
std::optional<double> number_in(const char* path) {
  std::ifstream in(path);
  double number = 0;
  if (in >> number) return number;
  return std::nullopt;  // also for "max"
}

#if defined(__EMSCRIPTEN__)

/// What the module's memory may still grow by, and what is free in it.
double memory_of_system() {
  const auto growth = static_cast<double>(emscripten_get_heap_max() - emscripten_get_heap_size());
  return growth + static_cast<double>(mallinfo().fordblks);
}

double memory_of_limit() { return kUnknown; }

#elif defined(BRINDLE_HAS_LIMITS)

/// Physical memory that could be had without swapping.
double memory_of_system() {
  std::ifstream in("/proc/meminfo");
  for (std::string word; in >> word;) {
    double kilobytes = 0;
    if (word == "MemAvailable:" && in >> kilobytes) return 1024 * kilobytes;
  }
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0 ? static_cast<double>(pages) * static_cast<double>(size) : kUnknown;
}

/// What the process may still map (ulimit -v).
double memory_of_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
  const double pages = number_in("/proc/self/statm").value_or(0);
  const double taken = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - taken);
}

#else

double memory_of_system() { return kUnknown; }
double memory_of_limit() { return kUnknown; }

#endif

/// Of the containers that a process may be in, the one that it sees as the whole.
double memory_of_group() {
  constexpr const char* kFiles[][2] = {
      {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"},
      {"/sys/fs/cgroup/memory/memory.limit_in_bytes",
       "/sys/fs/cgroup/memory/memory.usage_in_bytes"}};
  for (const auto& [limit_file, usage_file] : kFiles) {
    const auto limit = number_in(limit_file), usage = number_in(usage_file);
    if (limit && usage) return std::max(0.0, *limit - *usage);
  }
  return kUnknown;
}

/// Two digits, rounded by `round`.
template <class Round>
std::string in_two_digits(double number, const Round& round) {
  if (!(number > 0) || !std::isfinite(number)) return number > 0 ? "any" : "0";
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1);
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", round(number / unit) * unit);
  return text;
}

}  // namespace

double available_memory() {
  const double given = assumed;
  return given >= 0 ? given : std::min({memory_of_system(), memory_of_limit(), memory_of_group()});
}

double count_that_fits(double bytes_each) { return 0.5 * available_memory() / bytes_each; }

std::size_t size_in_bytes(std::uint64_t count, std::size_t bytes_each, const std::string& what) {
  if (count > std::numeric_limits<std::size_t>::max() / bytes_each) {
    throw Error(what + " is larger than memory");
  }
  return static_cast<std::size_t>(count) * bytes_each;
}

/// What fits now may not fit when it is asked for again.
constexpr double kSure = 0.6;

void check_fits(double count, double bytes_each, const std::string& what, const std::string& things,
                const std::function<std::string(double)>& remedy) {
  // What is small needs no asking.
  constexpr double kSmall = 1 << 20;
  if (count * bytes_each <= kSmall) return;
  const double most = count_that_fits(bytes_each);
  if (count <= most) return;
  throw TooLarge(what + " would be " + rounded_up(count) + " " + things +
                     ", and memory has room for " + rounded_down(most) + "; " +
                     remedy(kSure * most),
                 kSure * most / count);
}

std::string rounded_up(double number) {
  return in_two_digits(number, [](double x) { return std::ceil(x - 1e-9); });
}

std::string rounded_down(double number) {
  return in_two_digits(number, [](double x) { return std::floor(x + 1e-9); });
}

AssumedMemory::AssumedMemory(double bytes) : before_(assumed.exchange(bytes)) {}
AssumedMemory::~AssumedMemory() { assumed = before_; }

}  // namespace brindle
