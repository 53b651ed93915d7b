/// Numbers written as they stand in memory, little endian.
#pragma once

#include <bit>
#include <cstddef>
#include <vector>

#include "brindle/base/output_file.h"

namespace brindle {

static_assert(std::endian::native == std::endian::little, "binary files are little endian");

/// Bytes gathered and written in large pieces.
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

}  // namespace brindle
