/// Results that do not fit into memory are rejected before work on them begins: a system that
/// overcommits would kill the process later, without a message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "brindle/error.h"

namespace brindle {

/// Thrown for a result that does not fit into memory.
class TooLarge : public Error {
 public:
  TooLarge(const std::string& message, double most_share) : Error(message), share_(most_share) {}

  /// The share of the requested size that fits, between 0 and 1.
  double share() const { return share_; }

 private:
  double share_;
};

/// Bytes that this process may still allocate: free memory of the system, within the limits of the
/// process and of its control group. Infinite where none of these is known.
double available_memory();

/// Number of items of this size that fit. Half of the memory is left for later steps.
double count_that_fits(double bytes_each);

/// The size of `count` items of `bytes_each` bytes. Throws Error naming `what` on overflow, since
/// counts in files may exceed sizes of 32 bits.
std::size_t size_in_bytes(std::uint64_t count, std::size_t bytes_each, const std::string& what);

/// Throws TooLarge if fewer fit: "WHAT would be 2.3e+12 THINGS, and memory has room for 1.5e+08; ",
/// then `remedy(n)`. n is 60 % of what fits.
void check_fits(double count, double bytes_each, const std::string& what, const std::string& things,
                const std::function<std::string(double)>& remedy);

/// A number with two digits for such a message, rounded to the safe side.
std::string rounded_up(double number);
std::string rounded_down(double number);

/// Overrides the available memory during its lifetime, for tests.
class AssumedMemory {
 public:
  explicit AssumedMemory(double bytes);
  ~AssumedMemory();
  AssumedMemory(const AssumedMemory&) = delete;
  AssumedMemory& operator=(const AssumedMemory&) = delete;

 private:
  double before_;
};

// Resident memory of this process.

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
