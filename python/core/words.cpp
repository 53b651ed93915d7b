#include "words.h"

#include <algorithm>
#include <map>

#include "brindle/base/text.h"

namespace brindle::python {
namespace {

// Options whose arguments have other names.
const std::map<std::string, std::string>& other_names() {
  static const std::map<std::string, std::string> kNames = {
      {"lambda", "stiffness"},     {"curvature-direction", "curvature"},
      {"field", "directions"},     {"rotate", "rotate_field"},
      {"texture", "tile"},         {"frequency-range", "range"},
      {"cross", "crosses"},        {"along", "run"},
      {"tensor", "axis"},          {"tensor-order", "order"},
      {"stripes-v", "stripes[1]"}, {"frequency-v", "frequency[1]"}};
  return kNames;
}

std::string argument_of(const std::string& option) {
  const auto other = other_names().find(option);
  if (other != other_names().end()) return other->second;
  std::string argument = option;
  for (char& letter : argument) letter = letter == '-' ? '_' : letter;
  return argument;
}

}  // namespace

std::string in_pythons_words(const std::string& text) {
  return with_option_names(text, argument_of);
}

std::size_t choice(const std::string& option, const std::string& word) {
  saying_in_pythons_words([&] { check_choice(option, word); });
  const std::string all = '|' + std::string(row_of(option).form) + '|';
  return static_cast<std::size_t>(std::count(
      all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.find('|' + word + '|')), '|'));
}

}  // namespace brindle::python
