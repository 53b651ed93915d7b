#include "words.h"

#include <cctype>
#include <map>

namespace brindle::python {
namespace {

// Options whose arguments have other names.
const std::map<std::string, std::string>& other_names() {
  static const std::map<std::string, std::string> kNames = {
      {"lambda", "lambda_"},   {"curvature-direction", "curvature"},
      {"field", "directions"}, {"rotate", "turned_field"},
      {"texture", "tile"},     {"frequency-range", "range"},
      {"cross", "crosses"},    {"subdivide", "subdivided"}};
  return kNames;
}

std::string argument_of(const std::string& option) {
  const auto other = other_names().find(option);
  if (other != other_names().end()) return other->second;
  std::string argument = option;
  for (char& letter : argument) letter = letter == '-' ? '_' : letter;
  return argument;
}

bool is_of_option(char letter) {
  return std::islower(static_cast<unsigned char>(letter)) != 0 || letter == '-';
}

// Not within a word, such as a file name.
bool begins_option(const std::string& text, std::size_t i) {
  if (text.compare(i, 2, "--") != 0 || i + 2 >= text.size()) return false;
  if (std::islower(static_cast<unsigned char>(text[i + 2])) == 0) return false;
  return i == 0 || std::isspace(static_cast<unsigned char>(text[i - 1])) != 0;
}

}  // namespace

std::string in_pythons_words(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (!begins_option(text, i)) {
      result += text[i++];
      continue;
    }
    std::size_t end = i + 2;
    while (end < text.size() && is_of_option(text[end])) ++end;
    result += argument_of(text.substr(i + 2, end - i - 2));
    i = end;
  }
  return result;
}

}  // namespace brindle::python
