#include "brindle/distributed/selection.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace brindle {

// The bits of numbers that are not negative are ordered as they are.
float kth_smallest(Communicator& ranks, std::span<const float> numbers, std::size_t k) {
  std::uint32_t low = 0;
  auto high = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    const auto bound = std::bit_cast<float>(middle);
    const auto counted =
        std::ranges::count_if(numbers, [&](float number) { return number <= bound; });
    if (ranks.sum(static_cast<std::size_t>(counted)) > k) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return std::bit_cast<float>(low);
}

}  // namespace brindle
