/// Base64: bytes as letters, four for every three.
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

/// Decodes a text piece by piece. White space is passed over, and padding may also stand in the
/// middle, where one encoded text follows another.
class Base64Reader {
 public:
  explicit Base64Reader(std::string_view text) : text_(text) {}

  /// Fills `bytes` up to the end of the text or the first invalid letter. Returns how many bytes
  /// were decoded.
  std::size_t read_some(std::span<std::byte> bytes);

  /// No more bytes than these are left.
  std::size_t most_left() const { return left_over_ + text_.size() / 4 * 3 + 3; }

  /// Whether the whole text was read, and all of it was valid.
  bool at_end() const { return !damaged_ && left_over_ == 0 && text_.empty(); }

 private:
  /// Decodes as many bytes as stand in whole groups of four letters, without space or padding;
  /// returns how many.
  std::size_t read_plain(std::span<std::byte> bytes);
  /// Decodes the next group; false if it is none.
  bool next_group();

  std::string_view text_;
  std::array<std::byte, 3> group_{};
  std::size_t group_size_ = 0;
  std::size_t left_over_ = 0;  ///< bytes of the group that have not been handed out
  bool damaged_ = false;
};

/// Base64 of several pieces of memory as if they were one.
class Base64Writer {
 public:
  explicit Base64Writer(OutputStream& out) : out_(out) {}

  void put(const void* data, std::uint64_t size);
  /// Writes what is left over and the padding.
  void finish();

 private:
  void put_group(int letters);

  OutputStream& out_;
  std::uint32_t group_ = 0;
  int filled_ = 0;
};

/// All bytes of a text; nothing if it is not in base64.
std::optional<std::string> base64_decoded(std::string_view text);

}  // namespace brindle
