#include "brindle/base/number_text.h"

// Windows' libraries have both from_chars and to_chars.
#if !defined(_WIN32)

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

#include <locale.h>
#ifdef __APPLE__
#include <xlocale.h>
#endif

namespace brindle {
namespace {

/// Reads a decimal point, whatever the locale of the process.
double to_number(const char* text, char** end, double) {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  return strtod_l(text, end, plain);
}

float to_number(const char* text, char** end, float) {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  return strtof_l(text, end, plain);
}

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Length of the number at the start of the text, as std::from_chars reads it: without plus, white
/// space or base 16. 0 if there is none.
std::size_t length_of_number(std::string_view text) {
  std::size_t at = text.starts_with('-') ? 1 : 0;
  const auto begins = [&](std::string_view word) {
    for (std::size_t i = 0; i < word.size(); ++i) {
      if (at + i >= text.size() || (text[at + i] | 0x20) != word[i]) return false;
    }
    return true;
  };
  for (const std::string_view word : {"infinity", "inf", "nan"}) {
    if (begins(word)) return at + word.size();
  }
  std::size_t digits = 0;
  const auto pass_digits = [&] {
    for (; at < text.size() && is_digit(text[at]); ++at) ++digits;
  };
  pass_digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    pass_digits();
  }
  if (digits == 0) return 0;
  if (at < text.size() && (text[at] | 0x20) == 'e') {
    std::size_t end = at + 1;
    if (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
    const std::size_t first = end;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end > first) at = end;
  }
  return at;
}

template <class Number>
std::from_chars_result read_text(const char* first, const char* last, Number& value) {
  const std::size_t length = length_of_number({first, static_cast<std::size_t>(last - first)});
  if (length == 0) return {first, std::errc::invalid_argument};
  // The functions of C need a null at the end of the number.
  char near[64];
  std::string far;
  const char* text = near;
  if (length < sizeof near) {
    std::memcpy(near, first, length);
    near[length] = '\0';
  } else {
    far.assign(first, length);
    text = far.c_str();
  }
  const Number number = to_number(text, nullptr, Number());
  const bool is_word = std::strpbrk(text, "iInN") != nullptr;
  const bool is_zero = std::strpbrk(text, "123456789") == nullptr ||
                       std::strcspn(text, "123456789") > std::strcspn(text, "eE");
  if (!is_word && (std::isinf(number) || (number == 0 && !is_zero))) {
    return {first + length, std::errc::result_out_of_range};
  }
  value = number;
  return {first + length, std::errc()};
}

/// The fewest digits that read back the same value, as `d.ddde-05`.
template <class Number>
int write_digits(char* text, std::size_t size, Number value) {
  int length = 0;
  for (int digits = 0; digits < std::numeric_limits<Number>::max_digits10; ++digits) {
    length = std::snprintf(text, size, "%.*e", digits, static_cast<double>(value));
    for (char* c = text; *c != '\0'; ++c) {
      if (*c == ',') *c = '.';  // the locale of the process may use commas
    }
    if (to_number(text, nullptr, Number()) == value) break;
  }
  return length;
}

/// The same digits without exponent.
std::string without_exponent(std::string_view scientific, double value) {
  const bool negative = scientific.starts_with('-');
  const std::size_t e = scientific.find('e');
  std::string digits;
  for (const char letter : scientific.substr(0, e)) {
    if (is_digit(letter)) digits += letter;
  }
  const int exponent = std::atoi(std::string(scientific.substr(e + 1)).c_str());
  const int places = static_cast<int>(digits.size());
  std::string text;
  if (exponent < 0) {
    text = "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  } else if (exponent + 1 < places) {
    text = digits;
    text.insert(static_cast<std::size_t>(exponent) + 1, ".");
  } else {
    // Whole numbers are printed with all digits.
    char whole[400];
    std::snprintf(whole, sizeof whole, "%.0f", std::abs(value));
    text = whole;
  }
  return negative ? "-" + text : text;
}

template <class Number>
std::to_chars_result write_text(char* first, char* last, Number value) {
  char scientific[64];
  std::string text;
  if (std::isnan(value)) {
    text = std::signbit(value) ? "-nan" : "nan";
  } else if (std::isinf(value)) {
    text = value < 0 ? "-inf" : "inf";
  } else if (value == 0) {
    text = std::signbit(value) ? "-0" : "0";
  } else {
    const int length = write_digits(scientific, sizeof scientific, value);
    const std::string_view exact(scientific, static_cast<std::size_t>(length));
    text = without_exponent(exact, static_cast<double>(value));
    if (exact.size() < text.size()) text = exact;
  }
  if (static_cast<std::size_t>(last - first) < text.size()) {
    return {last, std::errc::value_too_large};
  }
  std::memcpy(first, text.data(), text.size());
  return {first + text.size(), std::errc()};
}

}  // namespace

std::from_chars_result read_portably(const char* first, const char* last, float& value) {
  return read_text(first, last, value);
}
std::from_chars_result read_portably(const char* first, const char* last, double& value) {
  return read_text(first, last, value);
}
std::to_chars_result write_portably(char* first, char* last, float value) {
  return write_text(first, last, value);
}
std::to_chars_result write_portably(char* first, char* last, double value) {
  return write_text(first, last, value);
}

}  // namespace brindle

#endif
