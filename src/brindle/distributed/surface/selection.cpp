#include "brindle/distributed/surface/selection.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace brindle {
namespace {

// The bits of numbers that are not negative are ordered as they are.
template <class Bits, class Number>
Number kth_by_bits(Communicator& ranks, std::span<const Number> numbers, std::size_t k) {
  Bits low = 0;
  auto high = std::bit_cast<Bits>(std::numeric_limits<Number>::infinity());
  while (low < high) {
    const Bits middle = low + (high - low) / 2;
    const auto bound = std::bit_cast<Number>(middle);
    const auto counted =
        std::ranges::count_if(numbers, [&](Number number) { return number <= bound; });
    if (ranks.sum(static_cast<std::size_t>(counted)) > k) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return std::bit_cast<Number>(low);
}

}  // namespace

float kth_smallest(Communicator& ranks, std::span<const float> numbers, std::size_t k) {
  return kth_by_bits<std::uint32_t>(ranks, numbers, k);
}

double kth_smallest(Communicator& ranks, std::span<const double> numbers, std::size_t k) {
  return kth_by_bits<std::uint64_t>(ranks, numbers, k);
}

}  // namespace brindle
