/// Text of messages: numbers, names and lines of unknown origin, suggestions for mistyped names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace brindle {

/// A character in UTF-8.
struct Utf8Letter {
  std::size_t bytes = 0;  ///< 0 if the text does not begin with one
  std::uint32_t code = 0;
};

/// The first character of a text. Only the shortest encoding is valid (RFC 3629).
Utf8Letter first_utf8_letter(std::string_view text);

/// Formats as std::printf does; std::format is not in g++ 12.
template <class... Values>
std::string formatted(const char* format, Values... values) {
  const int size = std::snprintf(nullptr, 0, format, values...);
  std::string text(static_cast<std::size_t>(size), '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

/// `text` for a terminal: bytes that are not printable ASCII as \xe9, and three dots for all after
/// the first `most` bytes.
std::string printable(std::string_view text, std::size_t most = 200);

/// `text` with \xe9 for every byte that is not part of a UTF-8 character. For JSON and Python,
/// which only accept UTF-8.
std::string utf8_text(std::string_view text);

/// A file name for a terminal. Characters of all languages stay, so that the name can be typed
/// again. Bytes that are not UTF-8, line breaks and other control characters become \x0a.
std::string shown(std::string_view name);

/// The same for a whole message, whose line breaks and tabs stay.
std::string shown_lines(std::string_view text);

/// A word or line of a file for a message: printable, short, in quotation marks.
std::string in_quotes(std::string_view text);

/// The name in `known` nearest to `word` by insertions, deletions, replacements and swaps of
/// neighbours: at most one per three of its letters, and at most three. Ignores case; ties go to
/// the first. Empty if none is near.
std::string nearest(std::string_view word, std::span<const std::string> known);

// Options of the tool in messages of programs that call them something else.

/// `text` with `name_of("field-smoothing")` in the place of "--field-smoothing", and so on for
/// every option that it names.
std::string with_option_names(std::string_view text,
                              const std::function<std::string(const std::string&)>& name_of);

}  // namespace brindle
