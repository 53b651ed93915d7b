/// Numbers of binary files.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "brindle/base/output_file.h"

namespace brindle {

static_assert(std::endian::native == std::endian::little, "binary files are little endian");

/// A buffered stream of bytes.
class BinaryOutput {
 public:
  explicit BinaryOutput(OutputStream& out) : out_(out) {}
  BinaryOutput(const BinaryOutput&) = delete;
  BinaryOutput& operator=(const BinaryOutput&) = delete;
  ~BinaryOutput() { flush(); }

  template <class Value>
  void put(const Value* values, std::size_t count) {
    const auto* bytes = reinterpret_cast<const char*>(values);
    buffer_.insert(buffer_.end(), bytes, bytes + count * sizeof(Value));
    if (buffer_.size() <= (1 << 16)) return;
    flush();
    stop_if_bad(out_);
  }
  template <class Value>
  void put(const Value& value) {
    put(&value, 1);
  }

 private:
  void flush() {
    out_.write(buffer_.data(), buffer_.size());
    buffer_.clear();
  }
  OutputStream& out_;
  std::vector<char> buffer_;
};

/// Swaps the bytes of numbers of `size` bytes each, from machines of the other byte order.
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

/// A colour's level as files store it: 0 to 1 becomes 0 to 255; NaN becomes 0.
inline unsigned char color_byte(float level) {
  return static_cast<unsigned char>(std::lround(255 * (level > 0 ? std::min(level, 1.0f) : 0.0f)));
}

}  // namespace brindle
