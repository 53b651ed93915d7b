#include "brindle/base/memory.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>

#include "brindle/base/system.h"

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
  return given >= 0
             ? given
             : std::min({system::free_memory(), system::mappable_memory(), memory_of_group()});
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
