#include "brindle/base/memory.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "brindle/base/system.h"

namespace brindle {
namespace {

std::atomic<double> assumed{-1};  // below 0: nothing is assumed

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
  return given >= 0 ? given
                    : std::min({system::free_memory(), system::mappable_memory(),
                                system::memory_of_group()});
}

double count_that_fits(double bytes_each) { return 0.5 * available_memory() / bytes_each; }

std::size_t size_in_bytes(std::uint64_t count, std::size_t bytes_each, const std::string& what) {
  if (count > std::numeric_limits<std::size_t>::max() / bytes_each) {
    throw Error(what + " is larger than memory");
  }
  return static_cast<std::size_t>(count) * bytes_each;
}

/// Share of what fits now that should also fit at the next attempt.
constexpr double kSure = 0.6;

void check_fits(double count, double bytes_each, const std::string& what, const std::string& things,
                const std::function<std::string(double)>& remedy) {
  // Small results need no check.
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

std::optional<ResidentMemory> resident_memory() {
  constexpr std::size_t kKibibyte = 1024;
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
