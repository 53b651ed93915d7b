/// Text of messages: numbers in it, names and lines of unknown origin, and what was meant by a
/// mistyped name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

namespace brindle {

/// A letter in UTF-8.
struct Utf8Letter {
  std::size_t bytes = 0;  ///< 0 if the text does not begin with one
  std::uint32_t code = 0;
};

/// The letter that a text begins with, in its shortest form alone (RFC 3629).
Utf8Letter first_utf8_letter(std::string_view text);

/// What std::printf would print; std::format is not in g++ 12.
template <class... Values>
std::string formatted(const char* format, Values... values) {
  const int size = std::snprintf(nullptr, 0, format, values...);
  std::string text(static_cast<std::size_t>(size), '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

/// `text` as a terminal can show it: bytes that are not printable ASCII as \xe9, and three dots
/// instead of what follows the first `most` bytes.
std::string printable(std::string_view text, std::size_t most = 200);

/// `text` with \xe9 for every byte that is not part of a letter in UTF-8; all else stays. For JSON
/// and Python, which hold nothing else.
std::string utf8_text(std::string_view text);

/// The name of a file as a terminal can show it: letters of all languages as they are, so that it
/// can be typed again; bytes that are not UTF-8, line breaks and what else a terminal would obey
/// as \x0a.
std::string shown(std::string_view name);

/// The same of a whole message, whose lines and tabulators stay.
std::string shown_lines(std::string_view text);

/// A word or line of a file for a message: printable, short, between quotation marks.
std::string in_quotes(std::string_view text);

/// Of `known`, the name that becomes `word` with the fewest letters put in, left out, replaced or
/// swapped with their neighbour: at most one in three of its letters, and at most three. Capitals
/// make no difference; of equally near names the first is taken. Empty if nothing is near.
std::string nearest(std::string_view word, std::span<const std::string> known);

}  // namespace brindle
