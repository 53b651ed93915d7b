/// Bytes on their way into an open file or a text.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/base/number_text.h"
#include "brindle/base/system.h"
#include "brindle/progress.h"

namespace brindle {

/// What goes into an open file, in large pieces. It keeps the system's reason for a failure, which
/// streams of the standard library forget, and needs none of their locales, a twelfth of a module
/// for browsers. After a failure, and once cancelled, it takes no more.
class OutputStream {
 public:
  /// `progress` hears of every few megabytes.
  OutputStream(system::Descriptor descriptor, const Progress& progress);
  /// Into a text, at once.
  explicit OutputStream(std::string& text) : text_(&text) {}
  OutputStream(const OutputStream&) = delete;
  OutputStream& operator=(const OutputStream&) = delete;

  OutputStream& write(const void* bytes, std::size_t count);

  OutputStream& operator<<(std::string_view text) { return write(text.data(), text.size()); }
  OutputStream& operator<<(const char* text) { return *this << std::string_view(text); }
  OutputStream& operator<<(char letter) { return write(&letter, 1); }
  OutputStream& operator<<(std::integral auto number) {
    char digits[24];
    const auto end = write_number(digits, digits + sizeof digits, number).ptr;
    return write(digits, static_cast<std::size_t>(end - digits));
  }

  /// Hands on what has gathered.
  void flush();

  /// Whether something could not be written; what comes after that is lost.
  bool bad() const { return reason_ != 0 || cancelled_; }

  /// 0, or the system's reason for the first failure.
  int reason() const { return reason_; }
  bool is_cancelled() const { return cancelled_; }

 private:
  void write_all(const char* bytes, std::size_t count);
  bool may_go_on();

  std::string* text_ = nullptr;
  system::Descriptor descriptor_ = -1;
  int reason_ = 0;
  std::vector<char> gathered_;
  Progress progress_;
  std::size_t passed_ = 0, since_report_ = 0;
  bool cancelled_ = false;
};

}  // namespace brindle
