/// Locale-independent numbers from and to text, also where the library's `from_chars` and
/// `to_chars` only support integers (libc++).
#pragma once

#include <charconv>
#include <concepts>
#include <version>

namespace brindle {

/// As std::from_chars and std::to_chars, with the same digits, for all libraries; slower.
std::from_chars_result read_portably(const char* first, const char* last, float& value);
std::from_chars_result read_portably(const char* first, const char* last, double& value);
std::to_chars_result write_portably(char* first, char* last, float value);
std::to_chars_result write_portably(char* first, char* last, double value);

template <std::floating_point Number>
std::from_chars_result read_number(const char* first, const char* last, Number& value) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, value);
#else
  return read_portably(first, last, value);
#endif
}

template <std::floating_point Number>
std::to_chars_result write_number(char* first, char* last, Number value) {
#ifdef __cpp_lib_to_chars
  return std::to_chars(first, last, value);
#else
  return write_portably(first, last, value);
#endif
}

template <std::integral Number>
std::to_chars_result write_number(char* first, char* last, Number value) {
  return std::to_chars(first, last, value);
}

}  // namespace brindle
