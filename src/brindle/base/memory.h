/// Results that no memory holds are refused before they are begun: a system that hands out more
/// than it has ends the process later, without a word.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "brindle/error.h"

namespace brindle {

/// Thrown for a result that memory does not hold.
class TooLarge : public Error {
 public:
  TooLarge(const std::string& message, double most_share) : Error(message), share_(most_share) {}

  /// How much of what was asked for there is room for, between 0 and 1.
  double share() const { return share_; }

 private:
  double share_;
};

/// Bytes that this process may still take: what the system has left, within the limits of the
/// process and of its control group. Infinite where none of it is known.
double available_memory();

/// How many things of so many bytes a result may have. Half of the memory is left for what is made
/// of it.
double count_that_fits(double bytes_each);

/// `count` things of so many bytes each in bytes. Throws Error naming `what` if no size is as
/// large: where sizes have 32 bits, counts of files may have more.
std::size_t size_in_bytes(std::uint64_t count, std::size_t bytes_each, const std::string& what);

/// Throws TooLarge if that is less than `count`: "WHAT would be 2.3e+12 THINGS, and memory has room
/// for 1.5e+08; " and what `remedy(count_that_fits)` says.
void check_fits(double count, double bytes_each, const std::string& what, const std::string& things,
                const std::function<std::string(double)>& remedy);

/// A number for such a message with two digits, on the safe side.
std::string rounded_up(double number);
std::string rounded_down(double number);

/// Lets the process believe in so much memory while it lives, as tests do.
class AssumedMemory {
 public:
  explicit AssumedMemory(double bytes);
  ~AssumedMemory();
  AssumedMemory(const AssumedMemory&) = delete;
  AssumedMemory& operator=(const AssumedMemory&) = delete;

 private:
  double before_;
};

}  // namespace brindle
