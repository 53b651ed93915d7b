#include "brindle/files/text/text_words.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <optional>
#include <type_traits>

#include "brindle/base/array_numbers.h"
#include "brindle/base/input_file.h"
#include "brindle/base/memory.h"
#include "brindle/base/text.h"

namespace brindle {
namespace {

bool is_white(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

template <class Number>
std::optional<Number> number_in(std::string_view word) {
  if constexpr (std::is_same_v<Number, float>) {
    const auto value = parse_number(word);
    return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
  } else if constexpr (std::is_same_v<Number, double>) {
    return parse_double(word);
  } else {
    if (word.starts_with('+')) word.remove_prefix(1);
    Number value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = end == word.data() + word.size() && error == std::errc();
    return whole ? std::optional(value) : std::nullopt;
  }
}

}  // namespace

std::string small_letters(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

std::string percent_decoded(std::string_view name) {
  std::string decoded;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = name.data() + i + 1;
    const bool escape = name[i] == '%' && i + 2 < name.size() &&
                        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    decoded.push_back(escape ? static_cast<char>(byte) : name[i]);
    if (escape) i += 2;
  }
  return decoded;
}

std::string_view take_word_of_lines(std::string_view& text) {
  const char* begin = text.data();
  const char* const last = begin + text.size();
  while (begin != last && is_white(*begin)) ++begin;
  const char* end = begin;
  while (end != last && !is_white(*end)) ++end;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return {begin, static_cast<std::size_t>(end - begin)};
}

std::vector<std::byte> take_numbers(std::string_view& text, NumberType type, std::uint64_t count,
                                    const std::function<void(const std::string&)>& fail) {
  const auto fail_short = [&] { fail("has fewer than " + std::to_string(count) + " numbers"); };
  // A number takes at least a character and a separator.
  if (count > (text.size() + 1) / 2) fail_short();
  std::vector<std::byte> bytes(size_in_bytes(count, size_of(type), "an array"));
  with_number_type(type, [&]<class Number>(Number) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::string_view word = take_word_of_lines(text);
      if (word.empty()) fail_short();
      const auto value = number_in<Number>(word);
      if (!value)
        fail("has " + in_quotes(word) + " for a number of type " + std::string(name_of(type)));
      std::memcpy(&bytes[i * sizeof(Number)], &*value, sizeof(Number));
    }
  });
  return bytes;
}

}  // namespace brindle
