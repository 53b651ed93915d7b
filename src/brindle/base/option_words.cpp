#include "brindle/base/option_words.h"

#include <cctype>

namespace brindle {

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
