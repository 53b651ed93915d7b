/// Base64: three bytes as four letters.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "brindle/base/output_file.h"

namespace brindle {

/// Decodes a text in parts. Skips white space, and allows padding in the middle, where encoded
/// texts are concatenated.
class Base64Reader {
 public:
  explicit Base64Reader(std::string_view text) : text_(text) {}

  /// Fills `bytes` up to the end of the text or the first invalid letter. Returns the number of
  /// bytes decoded.
  std::size_t read_some(std::span<std::byte> bytes);

  /// Upper bound on the bytes left.
  std::size_t most_left() const { return left_over_ + text_.size() / 4 * 3 + 3; }

  /// Whether the whole text was read, and all of it was valid.
  bool at_end() const { return !damaged_ && left_over_ == 0 && text_.empty(); }

 private:
  /// Decodes leading groups of four letters without space or padding; returns the number of bytes.
  std::size_t read_plain(std::span<std::byte> bytes);
  /// Decodes the next group; false if it is invalid.
  bool next_group();

  std::string_view text_;
  std::array<std::byte, 3> group_{};
  std::size_t group_size_ = 0;
  std::size_t left_over_ = 0;  ///< bytes of the group not yet returned
  bool damaged_ = false;
};

/// Encodes several blocks of memory as one.
class Base64Writer {
 public:
  explicit Base64Writer(OutputStream& out) : out_(out) {}

  void put(const void* data, std::uint64_t size);
  /// Writes the remaining bytes and the padding.
  void finish();

 private:
  void put_group(int letters);

  OutputStream& out_;
  std::uint32_t group_ = 0;
  int filled_ = 0;
};

/// The decoded text; nullopt if it is not base64.
std::optional<std::string> base64_decoded(std::string_view text);

}  // namespace brindle
