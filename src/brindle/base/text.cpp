#include "brindle/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <vector>

namespace brindle {
namespace {

void add_escaped(std::string& result, std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    (result += "\\x") += {kDigits[byte >> 4], kDigits[byte & 15]};
  }
}

/// Whether a terminal interprets the character: control characters, line ends, and marks that
/// change the direction of writing.
bool is_obeyed(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

template <class Obeyed>
std::string escaped(std::string_view text, const Obeyed& is_escaped) {
  std::string result;
  while (!text.empty()) {
    const Utf8Letter letter = first_utf8_letter(text);
    const std::size_t bytes = letter.bytes == 0 ? 1 : letter.bytes;
    if (letter.bytes == 0 || is_escaped(letter.code)) {
      add_escaped(result, text.substr(0, bytes));
    } else {
      result += text.substr(0, bytes);
    }
    text.remove_prefix(bytes);
  }
  return result;
}

}  // namespace

Utf8Letter first_utf8_letter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {1, first};
  const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
  if (bytes == 0 || first > 0xf4 || text.size() < bytes) return {};
  std::uint32_t code = first & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < kLeast[bytes] || code > 0x10ffff || surrogate) return {};
  return {bytes, code};
}

namespace {

constexpr std::size_t kMostEdits = 3;

bool alike(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// Edit distance: insertions, deletions, replacements, and swaps of neighbours.
std::size_t edits(std::string_view from, std::string_view to) {
  // Rows of the distance table: two before, one before, current.
  std::array<std::vector<std::size_t>, 3> rows;
  for (auto& row : rows) row.resize(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) rows[2][j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    rows[2][0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = rows[1][j - 1] + (alike(from[i - 1], to[j - 1]) ? 0 : 1);
      rows[2][j] = std::min({rows[1][j] + 1, rows[2][j - 1] + 1, replaced});
      const bool swapped =
          i > 1 && j > 1 && alike(from[i - 1], to[j - 2]) && alike(from[i - 2], to[j - 1]);
      if (swapped) rows[2][j] = std::min(rows[2][j], rows[0][j - 2] + 1);
    }
  }
  return rows[2][to.size()];
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  std::string result;
  for (const char& c : text.substr(0, most)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      result += c;
    } else {
      add_escaped(result, {&c, 1});
    }
  }
  if (text.size() > most) result += "...";
  return result;
}

std::string utf8_text(std::string_view text) {
  return escaped(text, [](std::uint32_t) { return false; });
}

std::string shown(std::string_view name) { return escaped(name, is_obeyed); }

std::string shown_lines(std::string_view text) {
  return escaped(
      text, [](std::uint32_t code) { return code != '\n' && code != '\t' && is_obeyed(code); });
}

std::string in_quotes(std::string_view text) {
  std::string quoted = "'";
  quoted += printable(text, 40);
  return quoted += '\'';
}

std::string nearest(std::string_view word, std::span<const std::string> known) {
  std::string best;
  std::size_t fewest = kMostEdits + 1;
  for (const std::string& name : known) {
    // The difference in length is a lower bound on the distance.
    if (word.size() > name.size() + kMostEdits || name.size() > word.size() + kMostEdits) continue;
    const std::size_t allowed = std::max<std::size_t>(1, name.size() / 3);
    const std::size_t distance = edits(word, name);
    if (distance > allowed || distance >= fewest || distance >= name.size()) continue;
    fewest = distance;
    best = name;
  }
  return best;
}

std::string with_option_names(std::string_view text,
                              const std::function<std::string(const std::string&)>& name_of) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    // Not within a word, as in the name of a file.
    const bool begins_word = i == 0 || std::isspace(static_cast<unsigned char>(text[i - 1])) != 0;
    const bool begins = begins_word && text.substr(i, 2) == "--" && i + 2 < text.size();
    if (!begins || !is_letter(text[i + 2])) {
      result += text[i++];
      continue;
    }
    std::size_t end = i + 2;
    while (end < text.size() && (is_letter(text[end]) || text[end] == '-')) ++end;
    result += name_of(std::string(text.substr(i + 2, end - i - 2)));
    i = end;
  }
  return result;
}

}  // namespace brindle
