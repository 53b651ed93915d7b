#include "words.h"

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

}  // namespace brindle::python
