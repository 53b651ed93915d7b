/// Numbers and choices that bytes stand for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "brindle/types.h"

namespace brindle::fuzz {

/// Takes one after the other; zeros where there are no more.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool is_empty() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }
  std::size_t below(std::size_t count) { return byte() % count; }
  bool flag() { return (byte() & 1) != 0; }

  /// Small numbers, and now and then any bits.
  float number() {
    const std::uint8_t first = byte();
    if (first != 255) return (static_cast<float>(first) - 127) / 16;
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits = bits << 8 | byte();
    float any = 0;
    std::memcpy(&any, &bits, sizeof any);
    return any;
  }
  Vec3 vector() {
    const float x = number(), y = number();
    return {x, y, number()};
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace brindle::fuzz
