#include "brindle/base/printable.h"

namespace brindle {

std::string printable(std::string_view text, std::size_t most) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string result;
  for (const char c : text.substr(0, most)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      result += c;
    } else {
      (result += "\\x") += {kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  if (text.size() > most) result += "...";
  return result;
}

std::string in_quotes(std::string_view text) {
  std::string quoted = "'";
  quoted += printable(text, 40);
  return quoted += '\'';
}

}  // namespace brindle
