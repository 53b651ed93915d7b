/// Text with numbers in it; std::format is not in g++ 12.
#pragma once

#include <cstdio>
#include <string>

namespace brindle {

/// What std::printf would print.
template <class... Values>
std::string formatted(const char* format, Values... values) {
  const int size = std::snprintf(nullptr, 0, format, values...);
  std::string text(static_cast<std::size_t>(size), '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

}  // namespace brindle
