/// Numbers and words written fast, floats in the shortest form that reads back the same.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "brindle/base/number_text.h"
#include "brindle/base/output_file.h"
#include "brindle/error.h"

namespace brindle {

/// Thrown by those who write much where the file takes no more: `write_file` knows why.
class OutputStopped : public Error {
 public:
  OutputStopped() : Error("the output takes no more") {}
};

inline void stop_if_bad(const OutputStream& out) {
  if (out.bad()) throw OutputStopped();
}

class TextOutput {
 public:
  explicit TextOutput(OutputStream& out) : out_(out) {}
  TextOutput(const TextOutput&) = delete;
  TextOutput& operator=(const TextOutput&) = delete;
  ~TextOutput() { flush(); }

  TextOutput& operator<<(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() > kFull) flush_on();
    return *this;
  }
  TextOutput& operator<<(const char* text) { return *this << std::string_view(text); }
  TextOutput& operator<<(char c) { return *this << std::string_view(&c, 1); }

  template <class Number>
  requires(std::is_arithmetic_v<Number>) TextOutput& operator<<(Number number) {
    char digits[32];
    const auto end = write_number(digits, digits + sizeof digits, number).ptr;
    return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
  }

 private:
  static constexpr std::size_t kFull = 1 << 16;

  void flush_on() {
    flush();
    stop_if_bad(out_);
  }

  void flush() {
    out_.write(buffer_.data(), buffer_.size());
    buffer_.clear();
  }

  OutputStream& out_;
  std::string buffer_;
};

}  // namespace brindle
