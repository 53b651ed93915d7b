/// Numbers of machines that store their bytes the other way round.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>

namespace brindle {

/// Turns round the bytes of numbers of `size` bytes each.
inline void reverse_bytes(std::span<std::byte> numbers, std::size_t size) {
  const auto reverse_all = [&]<std::size_t kSize>(std::integral_constant<std::size_t, kSize>) {
    for (std::size_t at = 0; at + kSize <= numbers.size(); at += kSize) {
      std::reverse(&numbers[at], &numbers[at] + kSize);
    }
  };
  if (size == 2) reverse_all(std::integral_constant<std::size_t, 2>());
  if (size == 4) reverse_all(std::integral_constant<std::size_t, 4>());
  if (size == 8) reverse_all(std::integral_constant<std::size_t, 8>());
}

}  // namespace brindle
